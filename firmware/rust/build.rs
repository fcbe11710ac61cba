//! Compiles the player's C++ sources, folder `cpp`, and a pipeline for the effects that are the crate's features, with
//! the C++ compiler of the target. It needs no other crate. Variables of the environment, as of the crate `cc`:
//! `CXX_<target>`, then `TARGET_CXX`, then `CXX`; the same for `CXXFLAGS` and `AR`.
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs, thread};

fn main() {
    let target = variable("TARGET");
    let sources = PathBuf::from(variable("CARGO_MANIFEST_DIR")).join("cpp");
    let out = PathBuf::from(variable("OUT_DIR"));
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-changed={}", sources.display());

    let mut units = units_of(&sources, &out);
    let pipeline = out.join("pipeline.cpp");
    fs::write(&pipeline, pipeline_for(&features())).expect("the pipeline's source is written");
    units.push(pipeline);

    let compiler = Compiler::of(&target, &sources);
    let objects = compiler.compile(&units);
    let library = out.join("libzstrip_player.a");
    let _ = fs::remove_file(&library);
    run(Command::new(tool("AR", &target, || Some(compiler.archiver()))).arg("crs").arg(&library).args(&objects));
    println!("cargo:rustc-link-search=native={}", out.display());
    println!("cargo:rustc-link-lib=static=zstrip_player");
}

fn variable(name: &str) -> String {
    env::var(name).unwrap_or_else(|_| panic!("{} is not set: cargo sets it for build scripts", name))
}

/// Returns the value for this target, for any target, or for everything.
fn tool(name: &str, target: &str, default: impl Fn() -> Option<String>) -> String {
    let of_target = format!("{}_{}", name, target.replace('-', "_"));
    for name in [of_target, format!("TARGET_{}", name), name.to_string()] {
        println!("cargo:rerun-if-env-changed={}", name);
        if let Ok(value) = env::var(&name) {
            return value;
        }
    }
    default().unwrap_or_default()
}

/// Returns the names of the features that are on; `default` is none of them.
fn features() -> Vec<String> {
    let mut names: Vec<String> = env::vars()
        .filter_map(|(name, _)| name.strip_prefix("CARGO_FEATURE_").map(str::to_lowercase))
        .filter(|name| name != "default")
        .collect();
    names.sort();
    names
}

fn pipeline_for(features: &[String]) -> String {
    let effects: String = features.iter().map(|name| format!(" | zstrip::effect::{}", name)).collect();
    format!(
        "// Written by build.rs: the pipeline for the crate's features.\n\
         #include \"zstrip_player/c_picker.hpp\"\n\
         #include \"zstrip_player/c_pipeline.hpp\"\n\n\
         constexpr zstrip::Effects kEffects = zstrip::Effects{{}}{};\n\n\
         extern \"C\" {{\n\
         extern const zstrip_pipeline zstrip_rust_pipeline;\n\
         extern const zstrip_picker zstrip_rust_picker;\n\
         constinit const zstrip_pipeline zstrip_rust_pipeline{{zstrip::drawn_with<kEffects>}};\n\
         constinit const zstrip_picker zstrip_rust_picker{{zstrip::pick_with<kEffects>}};\n\
         }}\n",
        effects
    )
}

/// Writes a file for each folder of sources, which includes them: their headers are parsed once.
fn units_of(sources: &Path, out: &Path) -> Vec<PathBuf> {
    let mut units = Vec::new();
    let mut folders = vec![sources.to_path_buf()];
    while let Some(folder) = folders.pop() {
        let entries = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {}", folder.display(), error));
        let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("a folder is read").path()).collect();
        files.sort();
        folders.extend(files.iter().filter(|file| file.is_dir()).cloned());
        let of_cpp = |file: &&PathBuf| file.extension().map_or(false, |end| end == "cpp");
        let includes: String =
            files.iter().filter(of_cpp).map(|file| format!("#include \"{}\"\n", file.display())).collect();
        if includes.is_empty() {
            continue;
        }
        let unit = out.join(format!("unit_{}.cpp", units.len()));
        fs::write(&unit, includes).expect("a unit is written");
        units.push(unit);
    }
    units
}

struct Compiler {
    /// A program that runs the compiler, such as `ccache`.
    wrapper: Option<String>,
    program: String,
    flags: Vec<String>,
}

impl Compiler {
    fn of(target: &str, sources: &Path) -> Compiler {
        let program = tool("CXX", target, || {
            Some(
                match target.split('-').next().unwrap_or("") {
                    cpu if cpu.starts_with("thumb") => "arm-none-eabi-g++",
                    cpu if cpu.starts_with("riscv32") => "riscv32-unknown-elf-g++",
                    "xtensa" => "xtensa-esp-elf-g++",
                    _ => "c++",
                }
                .to_string(),
            )
        });
        let optimised = match env::var("OPT_LEVEL").as_deref() {
            Ok("s") | Ok("z") => "-Os",
            _ => "-O2",
        };
        let mut flags: Vec<String> = ["-std=c++20", optimised, "-ffreestanding", "-fno-exceptions", "-fno-rtti"]
            .iter()
            .chain(&["-fno-threadsafe-statics", "-ffunction-sections", "-fdata-sections"])
            .chain(flags_of(target))
            .map(|flag| flag.to_string())
            .collect();
        if !target.contains("-none") {
            flags.push("-fPIC".to_string()); // programs of hosts are position independent
        }
        flags.extend(tool("CXXFLAGS", target, || None).split_whitespace().map(str::to_string));
        flags.push(format!("-I{}", sources.display()));
        // `ccache g++` are two words, unless a file has this name.
        match program.split_once(' ') {
            Some((wrapper, behind)) if !Path::new(&program).exists() => {
                Compiler { wrapper: Some(wrapper.to_string()), program: behind.trim().to_string(), flags }
            }
            _ => Compiler { wrapper: None, program, flags },
        }
    }

    fn command(&self) -> Command {
        match &self.wrapper {
            None => Command::new(&self.program),
            Some(wrapper) => {
                let mut command = Command::new(wrapper);
                command.arg(&self.program);
                command
            }
        }
    }

    /// Returns the archiver of the same toolchain.
    fn archiver(&self) -> String {
        match self.program.rsplit_once('-') {
            Some((prefix, "g++")) | Some((prefix, "gcc")) => format!("{}-ar", prefix),
            _ => "ar".to_string(),
        }
    }

    /// Compiles the files, as many at once as cargo allows.
    fn compile(&self, files: &[PathBuf]) -> Vec<PathBuf> {
        let jobs = env::var("NUM_JOBS").ok().and_then(|jobs| jobs.parse().ok()).unwrap_or(1).max(1);
        let objects: Vec<PathBuf> = files.iter().map(|file| file.with_extension("o")).collect();
        thread::scope(|scope| {
            for job in 0..jobs {
                let own = files.iter().zip(&objects).skip(job).step_by(jobs);
                scope.spawn(move || {
                    own.for_each(|(file, object)| {
                        run(self.command().args(&self.flags).arg("-c").arg(file).arg("-o").arg(object))
                    })
                });
            }
        });
        objects
    }
}

/// Returns what the compiler has to know of the target's processor.
fn flags_of(target: &str) -> &'static [&'static str] {
    match target {
        "thumbv6m-none-eabi" => &["-mthumb", "-mcpu=cortex-m0plus"],
        "thumbv7m-none-eabi" => &["-mthumb", "-mcpu=cortex-m3"],
        "thumbv7em-none-eabi" => &["-mthumb", "-mcpu=cortex-m4", "-mfloat-abi=soft"],
        "thumbv7em-none-eabihf" => &["-mthumb", "-mcpu=cortex-m4", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"],
        "thumbv8m.main-none-eabi" => &["-mthumb", "-mcpu=cortex-m33", "-mfloat-abi=soft"],
        "thumbv8m.main-none-eabihf" => &["-mthumb", "-mcpu=cortex-m33", "-mfloat-abi=hard", "-mfpu=fpv5-sp-d16"],
        "riscv32imc-unknown-none-elf" => &["-march=rv32imc", "-mabi=ilp32", "-mcmodel=medany"],
        "riscv32imac-unknown-none-elf" => &["-march=rv32imac", "-mabi=ilp32", "-mcmodel=medany"],
        _ => &[],
    }
}

fn run(command: &mut Command) {
    let status = command.status().unwrap_or_else(|error| panic!("{:?}: {}; set CXX and AR", command, error));
    if !status.success() {
        panic!("{:?}: {}", command, status);
    }
}
