//! Examples below the help of each command.

pub(crate) const DEMO: &str = "\
Examples:
  polhode demo --open";

pub(crate) const RUN: &str = "\
Examples:
  polhode run scene.toml -o motion.csv -o page.html
  polhode run example:diamond-4 --duration 2
  polhode run example:box-drop --tier stepped --second-opinion
  polhode run example:slider-crank-driven --plot torque:crank --against angle:crank -o torque.svg
  polhode run - --set gravity=[0,0,-1.62] -o - < scene.toml > motion.csv";

pub(crate) const RESUME: &str = "\
Example:
  polhode resume scene.checkpoint -o rest.csv";

pub(crate) const PLAN: &str = "\
Examples:
  polhode plan scene.toml
  polhode plan example:box-drop --json
  polhode plan example:masonry-arch --stability";

pub(crate) const COST: &str = "\
Examples:
  polhode cost scene.toml --html cost.html
  polhode cost scene.toml --target 1e-6
  polhode cost scene.toml --vary method.integrator=rk4,dop853 --vary method.step=0.01,0.001";

pub(crate) const SWEEP: &str = "\
Examples:
  polhode sweep scene.toml --vary bodies.brick.mass=1..2:8 --measure 'bodies.brick.position[2]@end' -o table.csv
  polhode sweep scene.toml --vary 'bodies.brick.mass=normal(1, 0.05)' --random 20 --measure 'max(bodies.brick.velocity)'
  polhode sweep scene.toml --vary bodies.brick.mass=1..2:40 -o all.csv --shard 2/8
  polhode sweep scene.toml --vary bodies.brick.mass=1..2 --random 20 --json --report page.html

A scene with [[uncertain]] values is drawn without --vary: polhode sweep scene.toml --random 100 -o table.csv";

pub(crate) const STANDS: &str = "\
Examples:
  polhode stands example:masonry-arch
  polhode stands example:masonry-arch --contacts
  polhode stands example:arch --picture arch.svg
  polhode stands example:arch --bisect arrays.stone.layout.arch.thickness=0.05..0.2 --digits 3
  polhode stands example:overhang-stack || echo \"it does not stand\"";

pub(crate) const PLAY: &str = "\
Examples:
  polhode play scene.toml -o play.html
  polhode play example:newtons-cradle -o cradle.html
  polhode play scene.toml --hash";

pub(crate) const DROP: &str = "\
Examples:
  polhode drop part.stl -n 100 --density 7850 --pictures poses
  polhode drop box:0.016,0.016,0.016 -n 60 --json
  polhode drop example:box-drop -n 20 -o throws.csv";

pub(crate) const JUDGE: &str = "\
Examples:
  polhode judge motion.csv scene.toml
  polhode judge motion.csv scene.toml --no-truth -o judged.svg
  polhode judge motion.csv scene.toml --tolerance 1e-6 --json";

pub(crate) const CHECK: &str = "\
Examples:
  polhode check scene.toml
  polhode check scene.toml --set bodies.brick.mass=2";

pub(crate) const MESH: &str = "\
Examples:
  polhode mesh part.stl --density 7850
  polhode mesh part.obj --repair -o mended.obj
  polhode mesh part.obj --decompose -o parts.obj";

pub(crate) const ELASTIC: &str = "\
Examples:
  polhode elastic --confined
  polhode elastic --tilt 30 --elements 18 --picture rectangle.svg
  polhode elastic --table --elements 8";

pub(crate) const SCHEMA: &str = "\
Example:
  polhode schema > scene.schema.json";

pub(crate) const COMPARE: &str = "\
Examples:
  polhode compare a.csv b.csv --atol 1e-9
  polhode compare a.csv b.csv -o differences.svg";

pub(crate) const VIEW: &str = "\
Examples:
  polhode view scene.toml -o page.html
  polhode view scene.toml motion.csv -o motion.gif
  polhode view scene.toml --still t=1.5 --camera top
  polhode view scene.toml --still t=0.5 --show velocities,traces -o shown.png";

pub(crate) const NEW: &str = "\
Examples:
  polhode new my-scene
  polhode new my-scene --from diamond-4";

pub(crate) const SCENES: &str = "\
Example:
  polhode scenes";

pub(crate) const COMPLETIONS: &str = "\
Examples:
  polhode completions bash > ~/.local/share/bash-completion/completions/polhode
  polhode completions zsh > ~/.zfunc/_polhode";
