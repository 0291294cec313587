//! Where the corners of a glTF are before anything moves: pushed by morph targets, then by the joints of a skin or the
//! place of a node.

use super::accessor::{Numbers, Shape, Store, unsupported};
use super::damaged;
use super::scene::{Attributes, Node, Primitive, Skin, World, placement};
use super::soup::{Kept, Soup};
use crate::Result;
use glam::{DMat4, DVec3};

/// Most morph targets of a primitive, and most of those that push.
const MOST_TARGETS: usize = 4096;
const MOST_PUSHING: usize = 256;
/// Most sets of four joints a corner.
const MOST_SETS: usize = 8;

/// The corners of a primitive as a node shows them.
pub(super) struct Pose<'a> {
    positions: Numbers<'a>,
    /// Morph targets with their weights.
    targets: Vec<(f64, Numbers<'a>)>,
    joints: Option<Joints<'a>>,
}

/// What holds the corners of a skin.
struct Joints<'a> {
    skin: &'a Skin,
    world: &'a World,
    inverse_bind: Option<Numbers<'a>>,
    /// Four joints a corner with their weights, once or more.
    sets: Vec<(Numbers<'a>, Numbers<'a>)>,
}

impl<'a> Pose<'a> {
    /// None for a primitive without positions.
    pub(super) fn new(
        store: &Store<'a>,
        world: &'a World,
        node: Option<&Node>,
        primitive: &Primitive,
        weights: &[f64],
    ) -> Result<Option<Pose<'a>>> {
        let Some(&positions) = primitive.attributes.get("POSITION") else { return Ok(None) };
        if primitive.extensions.is_draco()
            && store.scene.accessors.get(positions).is_some_and(|a| a.buffer_view.is_none())
        {
            return Err(unsupported(store.name, "Draco compression"));
        }
        let positions = store.numbers(positions, Shape::Vec3)?;
        let as_many = |numbers: Numbers<'a>| {
            let problem = "has corners with and without what moves them";
            if numbers.count >= positions.count { Ok(numbers) } else { Err(damaged(store.name, problem)) }
        };
        let weights = node.map(|node| &node.weights[..]).filter(|weights| !weights.is_empty()).unwrap_or(weights);
        let mut targets = Vec::new();
        for (target, &weight) in primitive.targets.iter().zip(weights) {
            if let Some(&target) = target.get("POSITION").filter(|_| weight != 0.0) {
                targets.push((weight, as_many(store.numbers(target, Shape::Vec3)?)?));
            }
        }
        if primitive.targets.len() > MOST_TARGETS || targets.len() > MOST_PUSHING {
            return Err(unsupported(store.name, "a mesh with so many morph targets"));
        }
        let skin = node.and_then(|node| store.scene.skins.get(node.skin?));
        let mut joints = None;
        if let Some(skin) = skin {
            let set = |attributes: &Attributes, i: usize| {
                Some((*attributes.get(&format!("JOINTS_{i}"))?, *attributes.get(&format!("WEIGHTS_{i}"))?))
            };
            let mut sets = Vec::new();
            for (names, weights) in (0..MOST_SETS).map_while(|i| set(&primitive.attributes, i)) {
                let pair = (store.names(names, Shape::Vec4)?, store.numbers(weights, Shape::Vec4)?);
                sets.push((as_many(pair.0)?, as_many(pair.1)?));
            }
            let inverse_bind = skin.inverse_bind_matrices.map(|at| store.numbers(at, Shape::Mat4)).transpose()?;
            let lacks = inverse_bind.as_ref().is_some_and(|matrices| matrices.count < skin.joints.len());
            if lacks {
                return Err(damaged(store.name, "has a skin with fewer matrices than joints"));
            }
            // A skin without weights holds nothing.
            joints = (!sets.is_empty()).then_some(Joints { skin, world, inverse_bind, sets });
        }
        Ok(Some(Pose { positions, targets, joints }))
    }

    /// Adds triangles over its corners, moved by `matrix` unless joints hold them. False if a triangle names a corner that
    /// is not there.
    pub(super) fn add(
        &self,
        triangles: impl Iterator<Item = [usize; 3]>,
        matrix: DMat4,
        soup: &mut Soup,
        kept: &mut Kept,
    ) -> bool {
        // A reflection turns triangles inside out.
        let mirrored = match &self.joints {
            Some(joints) => self.positions.count > 0 && joints.matrix(0).determinant() < 0.0,
            None => matrix.determinant() < 0.0,
        };
        let triangles = triangles.map(|[a, b, c]| if mirrored { [a, c, b] } else { [a, b, c] });
        let corner =
            |i: usize| self.joints.as_ref().map_or(matrix, |joints| joints.matrix(i)).transform_point3(self.pushed(i));
        soup.add_named(kept, self.positions.count, triangles, |i| corner(i).to_array())
    }

    /// Where corner `i` is for the morph targets, in the mesh's own space.
    fn pushed(&self, i: usize) -> DVec3 {
        let targets = self.targets.iter().map(|(weight, target)| *weight * DVec3::from(target.all::<3>(i)));
        DVec3::from(self.positions.all::<3>(i)) + targets.sum::<DVec3>()
    }
}

impl Joints<'_> {
    /// What moves a corner: its joints' matrices, mixed.
    fn matrix(&self, i: usize) -> DMat4 {
        let (mut sum, mut total) = (DMat4::ZERO, 0.0);
        for (names, weights) in &self.sets {
            for (name, weight) in names.all::<4>(i).into_iter().zip(weights.all::<4>(i)) {
                if weight != 0.0 {
                    sum += weight * self.joint(name as usize);
                    total += weight;
                }
            }
        }
        // Weights that are rounded do not quite add up; and what nobody holds goes with the first.
        if total != 0.0 { sum * (1.0 / total) } else { self.joint(self.sets[0].0.get(i, 0) as usize) }
    }

    fn joint(&self, at: usize) -> DMat4 {
        let Some(&node) = self.skin.joints.get(at) else { return DMat4::IDENTITY };
        let inverse_bind = self.inverse_bind.as_ref().map_or(DMat4::IDENTITY, |m| DMat4::from_cols_array(&m.all(at)));
        self.world.matrices[node] * inverse_bind
    }
}

/// The places that a node gives its mesh over and over.
pub(super) struct Instances<'a> {
    pub(super) count: usize,
    translation: Option<Numbers<'a>>,
    rotation: Option<Numbers<'a>>,
    scale: Option<Numbers<'a>>,
}

impl<'a> Instances<'a> {
    pub(super) fn new(store: &Store<'a>, attributes: &Attributes) -> Result<Instances<'a>> {
        let numbers = |what: &str, shape: Shape| attributes.get(what).map(|&at| store.numbers(at, shape)).transpose();
        let translation = numbers("TRANSLATION", Shape::Vec3)?;
        let rotation = numbers("ROTATION", Shape::Vec4)?;
        let scale = numbers("SCALE", Shape::Vec3)?;
        let count = [&translation, &rotation, &scale].into_iter().flatten().map(|numbers| numbers.count).min();
        Ok(Instances { count: count.unwrap_or(1), translation, rotation, scale })
    }

    /// Of one of them.
    ///
    /// # Panics
    /// If there are not so many.
    pub(super) fn matrix(&self, i: usize) -> DMat4 {
        placement(
            self.translation.as_ref().map_or([0.0; 3], |numbers| numbers.all(i)),
            self.rotation.as_ref().map_or([0.0, 0.0, 0.0, 1.0], |numbers| numbers.all(i)),
            self.scale.as_ref().map_or([1.0; 3], |numbers| numbers.all(i)),
        )
    }
}
