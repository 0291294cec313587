//! Every shader as a browser would take it, and its layouts against the processor's.
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga::{AddressSpace, Module, TypeInner};
use wire4d::gpu::{SHADER_LAYOUTS, STAGES, Stage};

fn checked(source: &str) -> Result<(Module, ModuleInfo), String> {
    let module = naga::front::wgsl::parse_str(source).map_err(|error| error.emit_to_string(source))?;
    let info = Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(&module)
        .map_err(|error| error.emit_to_string(source))?;
    Ok((module, info))
}

/// What a stage's entry point breaks.
fn faults(stage: &Stage, source: &str) -> Vec<String> {
    let (module, info) = match checked(source) {
        Ok(checked) => checked,
        Err(error) => return vec![error],
    };
    let mut faults = Vec::new();
    let Some(at) = module.entry_points.iter().position(|entry| entry.name == stage.name) else {
        return vec!["no such entry point".into()];
    };
    let [x, y, z] = module.entry_points[at].workgroup_size;
    if x * y * z > 256 {
        faults.push(format!("{} invocations", x * y * z));
    }
    let info = &info;
    let used = |space: fn(AddressSpace) -> bool| {
        let globals = module.global_variables.iter();
        globals.filter(move |(handle, global)| space(global.space) && !info.get_entry_point(at)[*handle].is_empty())
    };
    let storage = used(|space| matches!(space, AddressSpace::Storage { .. })).count();
    if storage > 8 {
        faults.push(format!("{storage} storage buffers"));
    }
    let size = |ty: &naga::Type| ty.inner.size(module.to_ctx());
    let shared: u32 =
        used(|space| space == AddressSpace::WorkGroup).map(|(_, global)| size(&module.types[global.ty])).sum();
    if shared > 16 << 10 {
        faults.push(format!("{shared} bytes a workgroup"));
    }
    let bound = used(|space| matches!(space, AddressSpace::Storage { .. } | AddressSpace::Uniform));
    let mut bindings: Vec<u32> = bound.filter_map(|(_, global)| global.binding).map(|b| b.binding).collect();
    bindings.sort_unstable();
    let slots: Vec<u32> = stage.slots.iter().map(|&slot| slot as u32).collect();
    if bindings != slots {
        faults.push(format!("uses bindings {bindings:?}, its table says {slots:?}"));
    }
    for (name, bytes, members) in SHADER_LAYOUTS {
        let found = module.types.iter().find(|(_, ty)| ty.name.as_deref() == Some(name));
        let Some((_, naga::Type { inner: TypeInner::Struct { members: found, span }, .. })) = found else {
            faults.push(format!("no structure {name}"));
            continue;
        };
        if *span as usize != *bytes {
            faults.push(format!("{name}: {span} bytes in the shader, {bytes} here"));
        }
        for (member, offset) in *members {
            let place = found.iter().find(|m| m.name.as_deref() == Some(member)).map(|m| m.offset as usize);
            if place != Some(*offset) {
                faults.push(format!("{name}.{member}: at {place:?} in the shader, at {offset} here"));
            }
        }
    }
    faults
}

#[test]
fn every_stage_is_plain_webgpu_and_agrees_on_layouts() {
    let faults: Vec<String> = STAGES
        .iter()
        .flat_map(|stage| faults(stage, &stage.source()).into_iter().map(|fault| format!("{}: {fault}", stage.name)))
        .collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn a_wrong_shader_is_seen() {
    let stage = &STAGES[Stage::index("adam")];
    let source = stage.source();
    assert!(faults(stage, &source).is_empty());
    let wrong = |from: &str, to: &str| {
        assert!(source.contains(from), "{from}");
        !faults(stage, &source.replacen(from, to, 1)).is_empty()
    };
    assert!(wrong("beta1: f32,\nbeta2: f32,", "beta2: f32,\nbeta1: f32,"), "members that swapped places");
    assert!(wrong("@workgroup_size(64)", "@workgroup_size(512)"), "too many invocations");
    assert!(wrong("let gradient = d_points[id.x];", "let gradient = d_points_image[id.x];"), "another buffer");
    assert!(wrong("sqrt(second", "subgroupAdd(second"), "what a browser need not have");
}
