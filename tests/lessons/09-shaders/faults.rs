//! Each fault stands in the code here and is recognised by its result alone.

use shaders_tasks::Shaders;

use crate::JUDGE;

#[test]
fn the_reference_earns_ten_points_for_any_seed() {
    JUDGE.check();
}

#[test]
fn each_fault_is_recognised() {
    use shaders::lighting::{Gouraud, Lighting};
    use shaders::source::{Texture, White};
    use shaders::{Uniforms, draw};

    /// Gouraud's lighting with a faulty brightness at the pixel. It leaves no triangle out, as a student's.
    struct Faulty(fn(f32) -> f32);

    impl Lighting for Faulty {
        type Constant = ();
        type Varying = f32;
        fn triangle(&self, _: &Uniforms, _: usize) -> Option<()> {
            Some(())
        }
        fn corner(&self, uniforms: &Uniforms, face: usize, corner: usize) -> f32 {
            Gouraud.corner(uniforms, face, corner)
        }
        fn intensity(&self, (): (), varying: f32) -> f32 {
            (self.0)(varying)
        }
    }

    let reference = JUDGE.reference;
    let gouraud = |gouraud, check, words| {
        JUDGE.recognises(&Shaders { gouraud, ..reference }, check, words);
    };
    gouraud(|uniforms, target| draw(uniforms, White, Faulty(|i| -i), target), "gouraud", "behind");
    gouraud(
        |uniforms, target| draw(uniforms, White, Faulty(|i| i.max(0.0)), target),
        "dropped",
        "drawn black",
    );
    let quantized = |quantized, words| {
        JUDGE.recognises(&Shaders { quantized, ..reference }, "steps", words);
    };
    quantized(
        |uniforms, target| draw(uniforms, White, Faulty(|i| (i * 5.0).round() / 5.0), target),
        "one step too bright",
    );
    quantized(|uniforms, target| draw(uniforms, White, Gouraud, target), "there are no steps");
    let upside_down = Shaders {
        gouraud_texture: |uniforms, target| {
            let mut texture = uniforms.texture.expect("this look is given one").clone();
            texture.flip_vertically();
            // In the check the square is as bright above as below.
            draw(&Uniforms { texture: Some(&texture), ..*uniforms }, Texture, Gouraud, target)
        },
        ..reference
    };
    JUDGE.recognises(&upside_down, "texture", "upside down");
}
