//! The nodes of a scene in their places.

use ::gltf::{Document, Node};
use glam::{DMat4, Mat4};

use super::damaged;
use crate::ReadProblem;

/// All nodes that the scene shows, parents before their children, each with its transformation to the world.
/// The scene is the default one, else the first, else all nodes that are nobody's child.
pub(super) fn placed(document: &Document) -> Result<Vec<(Node<'_>, DMat4)>, ReadProblem> {
    let scene = document.default_scene().or_else(|| document.scenes().next());
    let roots: Vec<Node<'_>> = match scene {
        Some(scene) => scene.nodes().collect(),
        None => roots(document),
    };
    below(document, roots)
}

/// The transformations of all nodes to the world, by their numbers, whatever the scene shows: joints of skins
/// need not be in it. None of a node that is its own parent.
pub(super) fn transforms(document: &Document) -> Result<Vec<Option<DMat4>>, ReadProblem> {
    let mut transforms = vec![None; document.nodes().len()];
    for (node, transform) in below(document, roots(document))? {
        transforms[node.index()] = Some(transform);
    }
    Ok(transforms)
}

/// The nodes that are nobody's child.
fn roots(document: &Document) -> Vec<Node<'_>> {
    let mut is_child = vec![false; document.nodes().len()];
    for child in document.nodes().flat_map(|node| node.children()) {
        is_child[child.index()] = true;
    }
    document.nodes().filter(|node| !is_child[node.index()]).collect()
}

/// Those nodes and all below them.
fn below<'a>(document: &'a Document, roots: Vec<Node<'a>>) -> Result<Vec<(Node<'a>, DMat4)>, ReadProblem> {
    let mut seen = vec![false; document.nodes().len()];
    let mut placed = Vec::new();
    // Chains may be deeper than a program's stack.
    let mut waiting: Vec<(Node<'_>, DMat4)> = Vec::new();
    waiting.extend(roots.into_iter().rev().map(|root| (root, DMat4::IDENTITY)));
    while let Some((node, parent)) = waiting.pop() {
        let index = node.index();
        if std::mem::replace(&mut seen[index], true) {
            return Err(damaged(format!("node {index} is reached twice: nodes must form trees")));
        }
        let own = Mat4::from_cols_array_2d(&node.transform().matrix());
        let transform = parent * own.as_dmat4();
        waiting.extend(node.children().map(|child| (child, transform)));
        placed.push((node, transform));
    }
    Ok(placed)
}
