//! Temporary.
use super::Mesh;
use crate::view::{Camera, Image, View};
/// Depths.
pub struct Depths {
    depth: Image,
    hit: Vec<(u32, [f64; 3])>,
    mesh_points: Vec<[[f64; 3]; 3]>,
}
impl Depths {
    /// Render.
    pub fn render(mesh: &Mesh, view: &View) -> Depths {
        let (w, h) = (view.width_px, view.height_px);
        let camera: Camera<f64> = view.camera();
        let mut depth = Image { width: w, height: h, data: vec![f32::INFINITY; w * h] };
        let mut hit = vec![(u32::MAX, [0.0; 3]); w * h];
        let project = |p: &[f64; 3]| {
            let q = [p[0], p[1], p[2], 0.0];
            let [x, y, _] = camera.project(&q);
            [x, y, camera.depth(&q)]
        };
        let px: Vec<_> = mesh.positions().iter().map(project).collect();
        for (t, tri) in mesh.triangles().iter().enumerate() {
            let [a, b, c] = tri.map(|i| px[i as usize]);
            let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
            if area == 0.0 {
                continue;
            }
            let lo = |k: usize| a[k].min(b[k]).min(c[k]).floor().max(0.0) as usize;
            let hi = |k: usize, n: usize| (a[k].max(b[k]).max(c[k]).ceil().max(0.0) as usize).min(n);
            for y in lo(1)..hi(1, h) {
                for x in lo(0)..hi(0, w) {
                    let (sx, sy) = (x as f64 + 0.5, y as f64 + 0.5);
                    let e =
                        |p: [f64; 3], q: [f64; 3]| ((q[0] - p[0]) * (sy - p[1]) - (q[1] - p[1]) * (sx - p[0])) / area;
                    let l = [e(b, c), e(c, a), e(a, b)];
                    if l.iter().any(|&v| v < 0.0) {
                        continue;
                    }
                    let inv = l[0] / a[2] + l[1] / b[2] + l[2] / c[2];
                    let z = (1.0 / inv) as f32;
                    if z < depth.data[y * w + x] {
                        depth.data[y * w + x] = z;
                        hit[y * w + x] = (t as u32, [l[0] / a[2] / inv, l[1] / b[2] / inv, l[2] / c[2] / inv]);
                    }
                }
            }
        }
        let mesh_points = mesh.triangles().iter().map(|t| t.map(|i| mesh.positions()[i as usize])).collect();
        Depths { depth, hit, mesh_points }
    }
    /// Silhouette.
    pub fn silhouette(&self) -> Image {
        Image { data: self.depth.data.iter().map(|z| if z.is_finite() { 1.0 } else { 0.0 }).collect(), ..self.depth }
    }
    /// Widened.
    pub fn widened(&self) -> Image {
        let (w, h) = (self.depth.width, self.depth.height);
        let mut out = self.depth.clone();
        for y in 0..h {
            for x in 0..w {
                let mut m = f32::NEG_INFINITY;
                for v in y.saturating_sub(1)..(y + 2).min(h) {
                    for u in x.saturating_sub(1)..(x + 2).min(w) {
                        m = m.max(self.depth.data[v * w + u]);
                    }
                }
                out.data[y * w + x] = m;
            }
        }
        out
    }
    /// Shade.
    pub fn shade(&self, f: impl Fn(&[f64; 3], &[f64; 3]) -> f32) -> Image {
        let data = self
            .hit
            .iter()
            .map(|&(t, l)| {
                if t == u32::MAX {
                    return 0.0;
                }
                let p = self.mesh_points[t as usize];
                let at: [f64; 3] = std::array::from_fn(|c| (0..3).map(|k| l[k] * p[k][c]).sum());
                let d = |a: [f64; 3], b: [f64; 3]| glam::DVec3::from(b) - glam::DVec3::from(a);
                let n = d(p[0], p[1]).cross(d(p[0], p[2])).normalize_or_zero().to_array();
                f(&at, &n)
            })
            .collect();
        Image { data, ..self.depth }
    }
}
