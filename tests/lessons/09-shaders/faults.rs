//! Each fault stands in the code here and is recognised by its result alone.

use shaders_tasks::{Shaders, draw};

use crate::JUDGE;

#[test]
fn the_reference_earns_ten_points_for_any_seed() {
    JUDGE.check();
}

#[test]
fn each_fault_is_recognised() {
    use shaders::Scene;
    use shaders::lighting::{Gouraud, Lighting};
    use shaders::source::{Texture, White};

    /// Gouraud's lighting with a faulty brightness at the pixel. It leaves no triangle out, as a student's.
    struct Faulty<'a>(Gouraud<'a>, fn(f32) -> f32);

    impl Lighting for Faulty<'_> {
        type Constant = ();
        type Varying = f32;
        fn triangle(&self, _: usize) -> Option<()> {
            Some(())
        }
        fn vertex(&self, face: usize, corner: usize) -> f32 {
            self.0.vertex(face, corner)
        }
        fn intensity(&self, constant: (), varying: f32) -> f32 {
            (self.1)(self.0.intensity(constant, varying))
        }
    }

    let reference = JUDGE.reference;
    let gouraud = |gouraud, check, words| {
        JUDGE.recognises(&Shaders { gouraud, ..reference }, check, words);
    };
    gouraud(
        |scene, target| draw(scene, target, White, Faulty(Gouraud::new(scene), |i| -i)),
        "gouraud",
        "behind",
    );
    gouraud(
        |scene, target| draw(scene, target, White, Faulty(Gouraud::new(scene), |i| i.max(0.0))),
        "dropped",
        "drawn black",
    );
    let quantized = |quantized, words| {
        JUDGE.recognises(&Shaders { quantized, ..reference }, "steps", words);
    };
    quantized(
        |scene, target| draw(scene, target, White, Faulty(Gouraud::new(scene), |i| (i * 5.0).round() / 5.0)),
        "one step too bright",
    );
    quantized(|scene, target| draw(scene, target, White, Gouraud::new(scene)), "there are no steps");
    let upside_down = Shaders {
        gouraud_texture: |scene, target| {
            let mut texture = scene.texture.expect("this look is given one").clone();
            texture.flip_vertically();
            // In the check the square is as bright above as below.
            let scene = Scene { texture: Some(&texture), normals: scene.normals.clone(), ..*scene };
            draw(&scene, target, Texture::new(&scene), Gouraud::new(&scene))
        },
        ..reference
    };
    JUDGE.recognises(&upside_down, "texture", "upside down");
}
