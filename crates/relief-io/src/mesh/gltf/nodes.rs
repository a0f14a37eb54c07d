//! Nodes of a scene with their transforms to the world.

use ::gltf::{Document, Node};
use glam::{DMat4, Mat4};

use super::damaged;
use crate::ReadProblem;

/// Returns all nodes of the scene, parents before their children, each with its transform to the
/// world. The scene is the default one, else the first; without any, all root nodes are taken.
pub(super) fn in_scene(document: &Document) -> Result<Vec<(Node<'_>, DMat4)>, ReadProblem> {
    let scene = document.default_scene().or_else(|| document.scenes().next());
    let roots: Vec<Node<'_>> = match scene {
        Some(scene) => scene.nodes().collect(),
        None => roots(document),
    };
    below(document, roots)
}

/// Returns the transforms of all nodes to the world, by their numbers, whether or not the scene
/// contains them: joints of skins may lie outside it. None for a node that is its own ancestor.
pub(super) fn transforms(document: &Document) -> Result<Vec<Option<DMat4>>, ReadProblem> {
    let mut transforms = vec![None; document.nodes().len()];
    for (node, transform) in below(document, roots(document))? {
        transforms[node.index()] = Some(transform);
    }
    Ok(transforms)
}

/// Nodes that are not a child of any other.
fn roots(document: &Document) -> Vec<Node<'_>> {
    let mut is_child = vec![false; document.nodes().len()];
    for child in document.nodes().flat_map(|node| node.children()) {
        is_child[child.index()] = true;
    }
    document.nodes().filter(|node| !is_child[node.index()]).collect()
}

/// Given nodes and all their descendants, with transforms.
fn below<'a>(document: &'a Document, roots: Vec<Node<'a>>) -> Result<Vec<(Node<'a>, DMat4)>, ReadProblem> {
    let mut visited = vec![false; document.nodes().len()];
    let mut nodes = Vec::new();
    // Recursion could overflow the stack: chains may be long.
    let mut pending: Vec<(Node<'_>, DMat4)> = Vec::new();
    pending.extend(roots.into_iter().rev().map(|root| (root, DMat4::IDENTITY)));
    while let Some((node, parent)) = pending.pop() {
        let index = node.index();
        if std::mem::replace(&mut visited[index], true) {
            return Err(damaged(format!("node {index} is reached twice: nodes must form trees")));
        }
        let own = Mat4::from_cols_array_2d(&node.transform().matrix());
        let transform = parent * own.as_dmat4();
        pending.extend(node.children().map(|child| (child, transform)));
        nodes.push((node, transform));
    }
    Ok(nodes)
}
