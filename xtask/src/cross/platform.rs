//! The platforms whose bits are compared, and what running a program for each needs.

use clap::ValueEnum;
use std::fmt;

/// A platform.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Platform {
    /// 64-bit Intel and AMD.
    #[value(name = "x86-64")]
    X86,
    /// 64-bit ARM.
    #[value(name = "aarch64")]
    Arm,
    /// WebAssembly with the system interface WASI.
    #[value(name = "wasm32")]
    Wasm,
}

/// What is to be known of a platform that is not the one of this machine.
#[derive(Debug)]
pub(super) struct Facts {
    /// Its word, in options and in lines.
    name: &'static str,
    /// The architecture, as the standard library calls it.
    architecture: &'static str,
    /// The target, as rustc calls it.
    pub(super) target: &'static str,
    /// A program that links for it; none where rustc brings one.
    pub(super) linker: Option<&'static str>,
    /// What rustc is asked for when it makes the program.
    pub(super) codegen: &'static [&'static str],
    /// Commands that run a program for it, the first that is on the path.
    pub(super) runners: &'static [&'static [&'static str]],
    /// What to install.
    pub(super) install: &'static str,
}

/// An emulated Linux has no C library to load at run time: it is put into the program.
const WITH_C_LIBRARY: &[&str] = &["-C", "target-feature=+crt-static"];

const X86: Facts = Facts {
    name: "x86-64",
    architecture: "x86_64",
    target: "x86_64-unknown-linux-gnu",
    linker: Some("x86_64-linux-gnu-gcc"),
    codegen: WITH_C_LIBRARY,
    runners: &[&["qemu-x86_64-static"], &["qemu-x86_64"]],
    install: "rustup target add x86_64-unknown-linux-gnu; the GCC for x86-64 and qemu-user (Debian: apt-get install \
gcc-x86-64-linux-gnu libc6-dev-amd64-cross qemu-user-static)",
};

const ARM: Facts = Facts {
    name: "aarch64",
    architecture: "aarch64",
    target: "aarch64-unknown-linux-gnu",
    linker: Some("aarch64-linux-gnu-gcc"),
    codegen: WITH_C_LIBRARY,
    runners: &[&["qemu-aarch64-static"], &["qemu-aarch64"]],
    install: "rustup target add aarch64-unknown-linux-gnu; the GCC for aarch64 and qemu-user (Debian: apt-get install \
gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user-static)",
};

const WASM: Facts = Facts {
    name: "wasm32",
    architecture: "wasm32",
    target: "wasm32-wasip1",
    linker: None,
    codegen: &[],
    // The program runs in the folder of the workspace and opens files of this folder alone.
    runners: &[&["wasmtime", "run", "--dir=."], &["python3", "xtask/strict-hash/run_wasm.py"]],
    install: "rustup target add wasm32-wasip1; wasmtime (https://wasmtime.dev, or the Python package: pip install \
        wasmtime)",
};

impl Platform {
    /// What is to be known of it.
    pub(super) fn facts(self) -> &'static Facts {
        match self {
            Self::X86 => &X86,
            Self::Arm => &ARM,
            Self::Wasm => &WASM,
        }
    }

    /// Whether this machine is one: programs for it are built and run as any other.
    pub(super) fn is_here(self) -> bool {
        self.facts().architecture == std::env::consts::ARCH
    }
}

impl fmt::Display for Platform {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.facts().name)
    }
}

#[cfg(test)]
mod tests {
    //! A platform has one name, in options and in lines.
    use super::*;

    #[test]
    fn names_are_those_of_the_option() {
        for platform in Platform::value_variants() {
            let option = platform.to_possible_value().map(|value| value.get_name().to_owned());
            assert_eq!(option, Some(platform.to_string()));
        }
        let here = Platform::value_variants().iter().filter(|platform| platform.is_here()).count();
        assert!(here <= 1);
    }
}
