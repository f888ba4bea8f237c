//! Draws lesson 3's pictures: `cargo run -p triangles`, and with `-- --model` the model.

use std::process::ExitCode;

use common::program::flags::LightFlag;
use common::program::model::ModelFlag;
use common::program::{Extras, Program, run, values};
use common::{Attributes, Color, Image, Lesson, Method, Model, Vec2};
use triangles::{Triangle, draw_model, flat_intensity};

/// A triangle, as `--triangle` gives it.
#[derive(Clone)]
struct Flat {
    /// The three corners, in pixels.
    corners: [Vec2; 3],
    color: Color,
}

/// The slides' three triangles.
const TRIANGLES: [Flat; 3] = [
    Flat {
        corners: [Vec2::new(10.0, 70.0), Vec2::new(50.0, 160.0), Vec2::new(70.0, 80.0)],
        color: Color::RED,
    },
    Flat {
        corners: [Vec2::new(180.0, 50.0), Vec2::new(150.0, 1.0), Vec2::new(70.0, 180.0)],
        color: Color::WHITE,
    },
    Flat {
        corners: [Vec2::new(180.0, 150.0), Vec2::new(120.0, 160.0), Vec2::new(130.0, 180.0)],
        color: Color::GREEN,
    },
];

/// How a model's triangles are coloured.
#[derive(Clone, Copy, clap::ValueEnum)]
enum Fill {
    /// Each triangle in a colour of its own, the same ones in every run.
    Random,
    /// Each triangle as bright as it faces the light.
    Flat,
}

#[derive(clap::Args)]
struct Flags {
    #[command(flatten)]
    model: ModelFlag,

    /// A triangle instead of the lesson's three, in pixels; may be repeated
    #[arg(long, value_name = "x0,y0,x1,y1,x2,y2[,rrggbb]", value_parser = flat, allow_hyphen_values = true, conflicts_with = "model")]
    triangle: Vec<Flat>,

    /// How the model's triangles are coloured
    #[arg(long, value_enum, default_value_t = Fill::Flat)]
    fill: Fill,

    #[command(flatten)]
    light: LightFlag,
}

fn flat(text: &str) -> Result<Flat, String> {
    let (numbers, color) = values::numbers_and_color::<f32, 6>(text)?;
    if !numbers.iter().all(|number| number.is_finite()) {
        return Err("a corner must be finite".into());
    }
    let corners = [0, 2, 4].map(|n| Vec2::new(numbers[n], numbers[n + 1]));
    Ok(Flat { corners, color: color.unwrap_or(Color::WHITE) })
}

struct Triangles {
    /// Instead of the triangles in the plane, if it is asked for.
    model: Option<Model>,
    flags: Flags,
}

impl Program for Triangles {
    type Flags = Flags;
    type Method = Triangle;

    const LESSON: Lesson = triangles::LESSON;
    const METHODS: &[Method<Triangle>] = triangles::METHODS;
    const DEFAULT: &str = "edges";

    fn load(flags: Flags) -> anyhow::Result<Self> {
        let asked_for = flags.model.file.is_some();
        let model = asked_for.then(|| flags.model.read(Attributes::default())).transpose()?;
        Ok(Self { model, flags })
    }

    fn size(&self) -> (u16, u16) {
        if self.model.is_some() { (800, 800) } else { (200, 200) }
    }

    fn draw(&mut self, method: &Triangle, picture: &mut Image) -> anyhow::Result<Extras> {
        let Flags { triangle, fill, light, .. } = &self.flags;
        match (&self.model, fill) {
            (None, _) => {
                let triangles = if triangle.is_empty() { TRIANGLES.as_slice() } else { triangle };
                for &Flat { corners, color } in triangles {
                    (method.draw)(corners, picture, color);
                }
            }
            (Some(model), Fill::Random) => {
                draw_model(model, method, picture, |n, _| Some(Color::random(n as u64)));
            }
            (Some(model), Fill::Flat) => draw_model(model, method, picture, |_, corners| {
                let intensity = flat_intensity(corners, light.direction);
                (intensity >= 0.0).then(|| Color::gray(intensity))
            }),
        }
        Ok(Extras::default())
    }
}

fn main() -> ExitCode {
    run::<Triangles>()
}
