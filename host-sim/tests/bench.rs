//! `microbrdf bench`: its form, and what it refuses. Its times are the host's own.

mod support;

use support::{Folder, run};

const SCENE: &str = "
[camera]
width = 64
height = 64
eye = [0, -9, 0]
target = [0, 0, 0]
fov = 20
[[light]]
kind = \"directional\"
direction = [0, -1, 1]
color = 1
[[sphere]]
center = [0, 0, 0]
radius = 1
material = \"it\"
[material.it]
model = \"metallic-phong\"
exponent = 20
";

#[test]
fn every_renderer_takes_its_turn() {
    let folder = Folder::new("bench");
    let scene = folder.file("scene.toml", SCENE);
    let text = run(&["bench", &scene, "--repeat", "1"]).output();
    let mut lines = text.lines();
    assert!(
        lines
            .next()
            .is_some_and(|line| line.starts_with("1024 x 1024 pixels"))
    );
    for name in ["f32", "micromath", "q31", "q15", "reference", "plain"] {
        let line = lines.next().expect("a line for each");
        assert!(
            line.starts_with(name) && line.contains(" ns a pixel"),
            "{line}"
        );
    }
    assert_eq!(lines.next(), None);
}

#[test]
fn what_the_plain_renderer_does_not_know_is_refused() {
    let folder = Folder::new("bench-refuses");
    let lamp = SCENE
        .replace("\"directional\"\ndirection", "\"point\"\nposition")
        .replace("[0, -1, 1]\ncolor", "[0, -3, 3]\nintensity");
    let scene = folder.file("lamp.toml", &lamp);
    run(&["bench", &scene]).mistake(&["lights are directional"]);
    for more in ["shadows = true", "samples = 4"] {
        let scene = folder.file("more.toml", format!("{more}\n{SCENE}"));
        run(&["bench", &scene]).mistake(&["no shadows and one sample"]);
    }
    let retro = SCENE.replace("metallic-phong", "retro-phong");
    let scene = folder.file("retro.toml", &retro);
    run(&["bench", &scene]).mistake(&["material.it"]);
    run(&["bench", &scene, "--repeat", "0"]).mistake(&["--repeat"]);
}
