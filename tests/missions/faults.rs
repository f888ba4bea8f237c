//! Each fault stands in the code here and is recognised by its result alone.

use checks::missions::judge::Verdict;
use checks::missions::{
    Answer, Mission, SEED, camera, gouraud, lines, shaders, textures, transforms, triangles, wireframe,
    zbuffer,
};
use common::{Color, IVec2, Image, Mat4, Vec2, Vec3};

/// What the checks say of these functions. Answers cross as text, as they do between processes.
fn verdicts<F>(mission: &Mission<F>, functions: &F, seed: u64) -> Vec<Verdict> {
    let tasks = mission.tasks(seed);
    let sheets = mission.key(seed);
    let cross = |answer: Answer| answer.to_string().parse().expect("it was just written");
    let judge = |(sheet, tasks): (&checks::missions::Sheet, &Vec<checks::missions::Task<F>>)| {
        let answers: Vec<Answer> =
            tasks.iter().map(|task| cross(Answer::Raw((task.work)(functions)))).collect();
        sheet.judge(&answers)
    };
    sheets.iter().zip(&tasks).map(judge).collect()
}

/// Checks that a fault costs the points of a check, and that its cause is said to be one with these words.
#[track_caller]
fn recognised<F>(mission: &Mission<F>, functions: &F, check: &str, words: &str) {
    let verdicts = verdicts(mission, functions, SEED);
    let verdict = verdicts.iter().find(|verdict| verdict.name == check).expect("there is such a check");
    assert_eq!(verdict.earned(), 0, "{verdict:?}");
    assert!(verdict.cause.is_some_and(|cause| cause.contains(words)), "{verdict:?}");
}

/// Checks that the reference is right whatever the seed, and that the points add up.
#[track_caller]
fn sound<F>(mission: &Mission<F>) {
    for seed in [SEED, 2, 3] {
        let verdicts = verdicts(mission, &mission.reference, seed);
        let wrong: Vec<_> = verdicts.iter().filter(|verdict| !verdict.wrong.is_empty()).collect();
        assert!(wrong.is_empty(), "{wrong:?}");
        assert_eq!(verdicts.iter().map(Verdict::earned).sum::<u32>(), 10);
    }
}

#[test]
fn references_earn_ten_points_for_any_seed() {
    sound(&lines::MISSION);
    sound(&wireframe::MISSION);
    sound(&triangles::MISSION);
    sound(&zbuffer::MISSION);
    sound(&textures::MISSION);
    sound(&gouraud::MISSION);
    sound(&transforms::MISSION);
    sound(&camera::MISSION);
    sound(&shaders::MISSION);
}

/// Other seeds make other inputs, so that a picture learnt by heart earns the picture's points at most.
#[test]
fn inputs_come_from_the_seed() {
    let inputs = |seed| -> Vec<String> {
        lines::MISSION
            .key(seed)
            .into_iter()
            .flat_map(|sheet| sheet.questions)
            .map(|asked| asked.input)
            .collect()
    };
    assert_eq!(inputs(1), inputs(1));
    assert_ne!(inputs(1), inputs(2));
    let only_picture = lines::Lines {
        line: |a, b, image, color| {
            if image.width() == 100 {
                ::lines::line(a, b, image, color);
            }
        },
    };
    let earned: u32 = verdicts(&lines::MISSION, &only_picture, SEED).iter().map(Verdict::earned).sum();
    assert_eq!(earned, 2);
}

#[test]
fn lesson_1() {
    let check = |line, check, words| recognised(&lines::MISSION, &lines::Lines { line }, check, words);
    let upside_down: fn(IVec2, IVec2, &mut Image, Color) = |a, b, image, color| {
        let top = image.height() - 1;
        ::lines::bresenham(a, b, image.bounds(), |x, y, _| image.set(x, top - y, color));
    };
    check(upside_down, "picture", "upside down");
    check(upside_down, "gentle", "upside down");
    let shifted: fn(IVec2, IVec2, &mut Image, Color) = |a, b, image, color| {
        ::lines::line(a + IVec2::X, b + IVec2::X, image, color);
    };
    check(shifted, "picture", "a pixel too far right");
    check(
        |a, b, image, color| ::lines::bresenham(a, b, image.bounds(), |x, y, _| image.set(y, x, color)),
        "steep",
        "x and y are swapped",
    );
    let one_short: fn(IVec2, IVec2, &mut Image, Color) = |a, b, image, color| {
        ::lines::bresenham(a, b, image.bounds(), |x, y, _| {
            if (x, y) != (b.x, b.y) {
                image.set(x, y, color);
            }
        });
    };
    check(one_short, "gentle", "the pixel at an end is missing");
    check(one_short, "backward", "the pixel at an end is missing");
    check(
        |a, b, image, color| {
            let [a, b] = if a.x < b.x { [a, b] } else { [b, a] };
            ::lines::slides::per_column(a, b, image.bounds(), |x, y, _| image.set(x, y, color));
        },
        "steep",
        "gaps",
    );
    // Ends not put in order: half-way, another pixel from either end.
    check(
        |a, b, image, color| {
            let middle = a + b;
            ::lines::bresenham(a, b, image.bounds(), |x, y, _| image.set(middle.x - x, middle.y - y, color));
        },
        "backward",
        "half-way",
    );
    check(|_, _, _, _| (), "picture", "nothing is drawn");
}

#[test]
fn lesson_2() {
    let check = |to_pixel, check, words| {
        let functions = wireframe::Wireframe { wireframe: ::wireframe::wireframe, to_pixel };
        recognised(&wireframe::MISSION, &functions, check, words);
    };
    let as_printed: fn(Vec3, &Image) -> IVec2 =
        |p, image| ((p.truncate() + 1.0) * image.size() / 2.0).as_ivec2();
    check(as_printed, "border", "off by one at the border");
    check(as_printed, "outside", "cut off towards 0");
    check(|p, image| ((p.truncate() + 1.0) * image.size() / 2.0).round().as_ivec2(), "pixel", "rounded");
    check(|p, image| ::wireframe::to_pixel(p * Vec3::new(1.0, -1.0, 1.0), image), "pixel", "upside down");
    let mirrored = wireframe::Wireframe {
        wireframe: |model, image, color| {
            ::wireframe::wireframe(model, image, color);
            image.flip_horizontally();
        },
        to_pixel: ::wireframe::to_pixel,
    };
    recognised(&wireframe::MISSION, &mirrored, "picture", "mirrored");
}

#[test]
fn lesson_3() {
    let reference = triangles::MISSION.reference;
    let check = |fill, check, words| {
        let functions = triangles::Triangles { fill, flat_intensity: reference.flat_intensity };
        recognised(&triangles::MISSION, &functions, check, words);
    };
    check(
        |corners, bounds, visit| ::triangles::barycentric(corners, bounds, visit),
        "sides",
        "visited twice",
    );
    check(
        |corners, bounds, visit| {
            ::triangles::fill(corners, bounds, |x, y, w| visit(x, y, Vec3::new(w.y, w.z, w.x)));
        },
        "weights",
        "the weights are swapped",
    );
    let down: ::triangles::Visit = |corners, bounds, visit| {
        let top = bounds.max.y + bounds.min.y;
        ::triangles::fill(corners, bounds, |x, y, weights| visit(x, top - y, weights));
    };
    check(down, "coverage", "upside down");
    let behind = triangles::Triangles {
        flat_intensity: |[a, b, c], light| ::triangles::flat_intensity([a, c, b], light),
        ..reference
    };
    recognised(&triangles::MISSION, &behind, "intensity", "behind");
}

#[test]
fn lesson_4() {
    let reference = zbuffer::MISSION.reference;
    let check = |fill_nearest, check, words| {
        let functions = zbuffer::Zbuffer { fill_nearest, z_f32: reference.z_f32 };
        recognised(&zbuffer::MISSION, &functions, check, words);
    };
    check(
        |corners, depths, store, visit| {
            ::zbuffer::fill_nearest(corners.map(|c| Vec3 { z: -c.z, ..c }), depths, store, visit);
        },
        "pairs",
        "wrong sign of depth",
    );
    check(
        |corners, depths, store, visit| {
            ::zbuffer::fill_nearest(corners.map(|c| Vec3 { z: -c.z, ..c }), depths, store, visit);
        },
        "depths",
        "wrong sign of depth",
    );
    check(
        |corners, depths, _, visit| {
            ::triangles::fill(corners.map(Vec3::truncate), depths.bounds(), visit);
        },
        "pairs",
        "the last one drawn is seen",
    );
    check(
        |corners, depths, store, visit| {
            let z = Vec3::from_array(corners.map(|corner| corner.z));
            ::triangles::fill(corners.map(Vec3::truncate), depths.bounds(), |x, y, weights| {
                if store(weights.dot(z)) < depths.get(x, y) {
                    depths.set(x, y, store(weights.dot(z)));
                    visit(x, y, weights);
                }
            });
        },
        "pairs",
        "nothing passes",
    );
    let equal = zbuffer::Zbuffer {
        z_f32: |surfaces, image| {
            let reversed: Vec<_> = surfaces.iter().rev().copied().collect();
            ::zbuffer::z_f32(&reversed, image)
        },
        ..reference
    };
    recognised(&zbuffer::MISSION, &equal, "equal", "nearer is >");
}

#[test]
fn lesson_5() {
    let reference = textures::MISSION.reference;
    let check = |texel, check, words| {
        recognised(&textures::MISSION, &textures::Textures { texel, ..reference }, check, words);
    };
    check(::textures::round, "within", "half a texel off");
    check(::textures::truncate, "border", "black from u = 1 on");
    check(::textures::repeat, "border", "repeated");
    check(|texture, uv| ::textures::texel(texture, Vec2::new(uv.x, 1.0 - uv.y)), "texels", "upside down");
    check(|texture, uv| ::textures::texel(texture, Vec2::new(uv.y, uv.x)), "texels", "x and y are swapped");
}

#[test]
fn lesson_6() {
    let reference = gouraud::MISSION.reference;
    let check = |intensities, check, words| {
        let functions = gouraud::Gouraud { intensities, gouraud: reference.gouraud };
        recognised(&gouraud::MISSION, &functions, check, words);
    };
    check(|normals, light| ::gouraud::intensities(normals, -light), "corners", "behind");
    check(
        |normals, light| ::gouraud::intensities(normals, light).max(Vec3::ZERO),
        "corners",
        "clamped at the corners",
    );
    check(|[a, b, c], light| ::gouraud::intensities([b, c, a], light), "corners", "the corners are swapped");
    let behind = gouraud::Gouraud {
        gouraud: |scene, image, place| {
            let normals = scene.normals.clone();
            ::gouraud::gouraud(&::gouraud::Scene { normals, light: -scene.light, ..*scene }, image, place)
        },
        ..reference
    };
    recognised(&gouraud::MISSION, &behind, "two sides", "the light comes from behind");
}

#[test]
fn lesson_7() {
    let reference = transforms::MISSION.reference;
    let viewport = |viewport, words| {
        let functions = transforms::Transforms { viewport, ..reference };
        recognised(&transforms::MISSION, &functions, "viewport", words);
    };
    viewport(|w, h, zoom| ::transforms::viewport(w, h, zoom).transpose(), "rows and columns");
    viewport(
        |w, h, zoom| ::transforms::viewport(w, h, zoom) * ::transforms::scale(Vec3::new(1.0, -1.0, 1.0)),
        "upside down",
    );
    viewport(|w, h, zoom| ::transforms::viewport(w, h, zoom / 2.0), "half as large");
    viewport(
        |w, h, zoom| {
            ::transforms::scale(Vec3::new(w * zoom, h * zoom, 1.0))
                * ::transforms::translate(Vec3::new(w / 2.0, h / 2.0, 0.0))
        },
        "order of the product",
    );
    let projection = |projection, words| {
        let functions = transforms::Transforms { projection, ..reference };
        recognised(&transforms::MISSION, &functions, "projection", words);
    };
    projection(|d| ::transforms::projection(-d), "the sign is wrong");
    projection(|d| ::transforms::projection(d).transpose(), "rows and columns");
    let behind = transforms::Transforms { place: |m, p| Some(m.project_point3(p)), ..reference };
    recognised(&transforms::MISSION, &behind, "behind", "behind the eye");
}

#[test]
fn lesson_8() {
    let reference = camera::MISSION.reference;
    let lookat = |lookat, words| {
        recognised(&camera::MISSION, &camera::Camera { lookat, ..reference }, "centre", words);
    };
    lookat(::camera::listing, "subtracted after turning");
    lookat(
        |eye, center, up| {
            let rows = ::camera::basis(eye, center, up)?;
            Some(Mat4::from_mat3(rows) * ::transforms::translate(center))
        },
        "the centre is added",
    );
    lookat(
        |eye, center, up| {
            let rows = ::camera::basis(eye, center, up)?;
            Some(Mat4::from_mat3(rows) * ::transforms::translate(-eye))
        },
        "the eye is subtracted",
    );
    let basis = |basis, words| {
        recognised(&camera::MISSION, &camera::Camera { basis, ..reference }, "basis", words);
    };
    basis(|eye, center, up| Some(::camera::basis(eye, center, up)?.transpose()), "stands in columns");
    basis(|eye, center, up| ::camera::basis(center, eye, up), "looks away");
    basis(
        |eye, center, up| {
            let z = (eye - center).normalize();
            let x = up.cross(z);
            Some(common::Mat3::from_cols(x, z.cross(x), z).transpose())
        },
        "not 1 long",
    );
    basis(
        |eye, center, up| {
            let z = (eye - center).normalize();
            let x = up.cross(z).normalize();
            Some(common::Mat3::from_cols(x, x.cross(z), z).transpose())
        },
        "upside down",
    );
}

#[test]
fn lesson_9() {
    use ::shaders::lighting::{Gouraud, Lighting};
    use ::shaders::source::{Texture, White};
    use ::shaders::{Uniforms, draw};

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

    let reference = shaders::MISSION.reference;
    let gouraud = |gouraud, check, words| {
        recognised(&shaders::MISSION, &shaders::Shaders { gouraud, ..reference }, check, words);
    };
    gouraud(|uniforms, target| draw(uniforms, White, Faulty(|i| -i), target), "gouraud", "behind");
    gouraud(
        |uniforms, target| draw(uniforms, White, Faulty(|i| i.max(0.0)), target),
        "dropped",
        "drawn black",
    );
    let quantized = |quantized, words| {
        recognised(&shaders::MISSION, &shaders::Shaders { quantized, ..reference }, "steps", words);
    };
    quantized(
        |uniforms, target| draw(uniforms, White, Faulty(|i| (i * 5.0).round() / 5.0), target),
        "one step too bright",
    );
    quantized(|uniforms, target| draw(uniforms, White, Gouraud, target), "there are no steps");
    let upside_down = shaders::Shaders {
        gouraud_texture: |uniforms, target| {
            let mut texture = uniforms.texture.expect("this look is given one").clone();
            texture.flip_vertically();
            // In the check the square is as bright above as below.
            draw(&Uniforms { texture: Some(&texture), ..*uniforms }, Texture, Gouraud, target)
        },
        ..reference
    };
    recognised(&shaders::MISSION, &upside_down, "texture", "upside down");
}
