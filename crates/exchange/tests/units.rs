//! Units of length that files state.

use exchange::{CurveFile, LengthUnit, read_curves};

fn read(name: &str, text: &str) -> CurveFile {
    read_curves(text.as_bytes(), name).unwrap_or_else(|error| panic!("{name}: {error}\n{text}"))
}

fn dxf(insunits: &str) -> String {
    format!(
        "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n{insunits}\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n1\n21\n0\n\
         0\nENDSEC\n0\nEOF\n"
    )
}

/// A STEP file with a unit of length, its lines from #20 on.
fn step(unit: &str) -> String {
    format!(
        "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=CARTESIAN_POINT('',(0.,0.,0.));\n#2=CARTESIAN_POINT('',(1.,0.,0.));\n\
         #3=POLYLINE('',(#1,#2));\n#10=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#20))REPRESENTATION_CONTEXT('',''));\n\
         {unit}\nENDSEC;\nEND-ISO-10303-21;\n"
    )
}

fn obj(comment: &str) -> String {
    format!("# an exporter\n#{comment}\nv 0 0 0\nv 1 0 0\nl 1 2\n")
}

#[test]
fn every_kind_of_file_says_what_its_numbers_are() {
    let si = |prefix: &str| step(&format!("#20=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT({prefix},.METRE.));"));
    let measured = |name: &str, prefix: &str, count: f64| {
        step(&format!(
            "#20=(CONVERSION_BASED_UNIT('{name}',#21)LENGTH_UNIT()NAMED_UNIT(#23));\n\
             #21=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE({count:?}),#22);\n\
             #22=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT({prefix},.METRE.));\n#23=DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);"
        ))
    };
    let table = |heading: &str| format!("side,{heading}\na,0,0,0\na,1,0,0\n");
    for (name, text, unit) in [
        ("a.dxf", dxf("1"), Some(LengthUnit::Inch)),
        ("a.dxf", dxf("6"), Some(LengthUnit::Metre)),
        ("a.dxf", dxf("21"), Some(LengthUnit::SurveyFoot)),
        ("a.dxf", dxf("0"), None),
        ("a.dxf", dxf("3"), None),
        ("a.step", si(".MILLI."), Some(LengthUnit::Millimetre)),
        ("a.step", si("$"), Some(LengthUnit::Metre)),
        ("a.step", si(".PICO."), None),
        ("a.step", measured("INCH", ".MILLI.", 25.4), Some(LengthUnit::Inch)),
        // By its measure, whatever it is called.
        ("a.step", measured("Zoll", "$", 0.0254), Some(LengthUnit::Inch)),
        ("a.step", measured("FOOT", "$", 1200.0 / 3937.0), Some(LengthUnit::SurveyFoot)),
        ("a.step", measured("ELLE", "$", 0.57), None),
        ("a.obj", obj(" File units = meters"), Some(LengthUnit::Metre)),
        ("a.obj", obj("Units: mm"), Some(LengthUnit::Millimetre)),
        ("a.obj", obj(" 12 unit tests"), None),
        ("a.obj", obj(" metres"), Some(LengthUnit::Metre)),
        ("a.obj", obj(" units [ft]"), Some(LengthUnit::Foot)),
        ("a.obj", obj(" unit = ft"), Some(LengthUnit::Foot)),
        ("a.obj", obj(" all dimensions in mm."), Some(LengthUnit::Millimetre)),
        // A comment that only names one counts less than one that states it.
        ("a.obj", obj(" metres\n# Units: mm"), Some(LengthUnit::Millimetre)),
        ("a.obj", obj(" the yard"), None),
        ("a.obj", obj(" yard"), None),
        ("a.obj", obj(" m"), None),
        ("a.obj", obj(" 7 metres of rope"), None),
        ("a.csv", format!("# metres\n{}", table("x,y,z")), Some(LengthUnit::Metre)),
        ("a.csv", format!("# coordinates in feet\n{}", table("x,y,z")), Some(LengthUnit::Foot)),
        ("a.csv", format!("# units: mm\n{}", table("x [mm],y [mm],z [mm]")), Some(LengthUnit::Millimetre)),
        ("a.csv", table("x [mm],y [mm],z [mm]"), Some(LengthUnit::Millimetre)),
        ("a.csv", table("X (ft),Y (ft),Z (ft)"), Some(LengthUnit::Foot)),
        ("a.csv", table("x,y,z [m]"), None),
        ("a.csv", table("x,y,z"), None),
    ] {
        let file = read(name, &text);
        assert_eq!(file.unit, unit, "{text}");
        if let Some(unit) = unit {
            assert!(
                file.notes.iter().any(|note| note.to_string().contains(unit.plural())),
                "{:?}",
                file.notes
            );
        }
    }
    let two = read_curves(table("x [mm],y [m],z [mm]").as_bytes(), "a.csv").unwrap_err().to_string();
    assert!(two.contains("millimetres and metres"), "{two}");
    let text = format!("# metres\n{}", table("x [mm],y [mm],z [mm]"));
    let two = read_curves(text.as_bytes(), "a.csv").unwrap_err().to_string();
    assert!(two.contains("millimetres and a comment metres"), "{two}");
}

#[test]
fn files_in_two_units_are_no_boundary() {
    let [inches, metres, none] = ["1", "6", "0"].map(|unit| read("a.dxf", &dxf(unit)));
    let joined = |one: &CurveFile, two: &CurveFile| one.clone().with(two.clone());
    assert_eq!(joined(&inches, &none).unwrap().unit, Some(LengthUnit::Inch));
    assert_eq!(joined(&none, &metres).unwrap().unit, Some(LengthUnit::Metre));
    assert_eq!(joined(&none, &none).unwrap().unit, None);
    let said = joined(&inches, &metres).unwrap_err().to_string();
    assert!(said.contains("inches") && said.contains("metres"), "{said}");
}
