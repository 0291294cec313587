//! What a network sees in pictures: `embed NETWORK.onnx PICTURE...` prints a unit vector as JSON for each, a line each. A picture is
//! ink as `wire4d render` writes it, white where it is.

use std::path::Path;
use wire4d_core::objective::embedding;
use wire4d_core::view::Image;
use wire4d_core::work::wait;
use wire4d_guidance::OnnxNetwork;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let file = arguments.next().ok_or("say which network, then pictures")?;
    let mut network = OnnxNetwork::open(Path::new(&file))?;
    for path in arguments {
        let picture = image::open(&path).map_err(|error| format!("{path}: {error}"))?.to_luma16();
        let (width, height) = picture.dimensions();
        let data = picture.pixels().map(|pixel| f32::from(pixel.0[0]) / 65535.0).collect();
        let ink = Image { width: width as usize, height: height as usize, data };
        println!("{}", serde_json::to_string(&wait(embedding(&mut network, &ink))?)?);
    }
    Ok(())
}
