//! Sound experiment files become the plans they describe.

use exchange::{Format, LengthUnit, StepForm};
use experiment::{Experiment, FilmExperiment, Options, Output, PatchExperiment, Plan, Rim, Template, run};
use plateau::{
    Boundary, Construction, CurveBasis, DeformationPath, Direction, Done, Energy, Family, FillEnergy,
    Filling, FixedShape, Functional, Functions, Loop, Method, Quantity, Remark, Search, SearchEnergy,
    SearchMode, ShapedFamily, SolverChoice, TensorInterior, TriangleInterior, TriangleMask, Variant,
};

/// The functions and the interior of a method over four sides.
fn tensor(method: &Method) -> (&Functions, TensorInterior) {
    match method.filling() {
        Filling::Tensor { functions, interior } => (functions, *interior),
        Filling::Triangle(interior) => panic!("{interior:?}"),
    }
}

fn gt(mode: SearchMode, energy: Energy) -> Functions {
    Functions::Searched { family: ShapedFamily::Gt, mode, energy: energy.into() }
}

fn extremal(energy: Functional) -> TensorInterior {
    TensorInterior::Extremal { energy, solver: SolverChoice::Auto }
}

fn plan(text: &str) -> Plan {
    Plan::parse("some/folder/net.one.toml", text).unwrap_or_else(|refusal| panic!("{refusal}"))
}

fn patches(plan: &Plan) -> &PatchExperiment {
    match &plan.experiment {
        Experiment::Patch(patches) => patches,
        other => panic!("no patches: {other:?}"),
    }
}

/// The boundary of GT Example 5.1 with the methods of `text`.
fn methods(text: &str) -> Vec<Method> {
    patches(&plan(&format!("{NET}{text}"))).methods.clone()
}

const NET: &str = r#"title = "Bicubic boundary net I"
seed = 7                                  # default 0

[boundary]
u0 = [[0,0,0],[2,0,2],[4,0,-2],[6,0,0]]   # P_{0,j}
u1 = [[0,6,0],[2,6,2],[4,6,-2],[6,6,0]]   # P_{m,j}
v0 = [[0,0,0],[0,2,2],[0,4,-2],[0,6,0]]   # P_{i,0}
v1 = [[6,0,0],[6,2,2],[6,4,-2],[6,6,0]]   # P_{i,n}
"#;

const EXAMPLE: &str = r#"
[[method]]                                # one row of the table each
name = "GT Dirichlet + PSO"
basis = "gt"                              # "bernstein" | "gt"
energy = "dirichlet"
search = true

[[method]]
name = "Bernstein Dirichlet"
basis = "bernstein"
energy = "dirichlet"

[search]
variant = "global"                        # "global" | "local"
particles = 50
iterations = 100
runs = 10
inertia = 0.7
social = 1.5
cognitive = 1.5
box = [0.5, 3.5]
neighbours = 2                            # ring neighbours on each side, local variant
"#;

#[test]
fn the_tensor_example() {
    let text = format!("{NET}{EXAMPLE}");
    let plan = plan(&text);
    assert_eq!((plan.title.as_str(), plan.seed), ("Bicubic boundary net I", 7));
    assert_eq!((plan.stem.as_str(), plan.file.as_str()), ("net.one", "some/folder/net.one.toml"));
    assert_eq!(plan.text, text);
    assert_eq!(plan.output, Output { mesh: 48, formats: vec![], pictures: true, step: StepForm::default() });
    let patches = patches(&plan);
    let Boundary::Tensor(boundary) = &patches.boundary else { panic!("{:?}", patches.boundary) };
    let [u0, u1, v0, v1] = boundary.sides();
    assert_eq!(<[f64; 3]>::from(u0[1]), [2.0, 0.0, 2.0]);
    assert_eq!(<[f64; 3]>::from(u1[2]), [4.0, 6.0, -2.0]);
    assert_eq!(<[f64; 3]>::from(v0[1]), [0.0, 2.0, 2.0]);
    assert_eq!(<[f64; 3]>::from(v1[3]), [6.0, 6.0, 0.0]);
    assert_eq!(boundary.welded(), 0.0);
    assert_eq!(patches.boundary.degrees(), (3, 3));
    assert_eq!(patches.search, Search::default());
    let [searched, bernstein] = patches.methods.as_slice() else { panic!("{:?}", patches.methods) };
    assert_eq!((searched.name(), searched.raise()), ("GT Dirichlet + PSO", 0));
    let functions = gt(SearchMode::PsoPolish, Energy::DIRICHLET);
    assert_eq!(tensor(searched), (&functions, extremal(Functional::Dirichlet)));
    assert_eq!(tensor(bernstein), (&Functions::Bernstein, extremal(Functional::Dirichlet)));
    assert!(
        plan.wanted.len() == 2 && plan.wanted.iter().all(|w| w.expect.is_empty() && w.published.is_empty())
    );
}

#[test]
fn degrees_follow_the_lengths_of_rows_and_columns() {
    let text = r#"
        title = "Degree (1, 2)"
        boundary = { u0 = [[0,0,0],[0,1,0],[0,2,0]], u1 = [[1,0,0],[1,1,0],[1,2,0]], v0 = [[0,0,0],[1,0,0]], v1 = [[0,2,0],[1,2,0]] }
        [[method]]
        name = "a"
        energy = "area"
    "#;
    assert_eq!(patches(&plan(text)).boundary.degrees(), (1, 2));
    assert_eq!(plan(text).seed, 0);
}

#[test]
fn every_way_to_say_search_and_shape() {
    let fixed =
        |shape: [f64; 4]| Functions::Shaped(FixedShape::new(ShapedFamily::Gt, shape.to_vec()).unwrap());
    for (line, functions) in [
        ("search = true", gt(SearchMode::PsoPolish, Energy::DIRICHLET)),
        ("search = \"pso\"", gt(SearchMode::Pso, Energy::DIRICHLET)),
        ("search = \"polish\"", gt(SearchMode::Polish, Energy::DIRICHLET)),
        ("search = \"pso-polish\"", gt(SearchMode::PsoPolish, Energy::DIRICHLET)),
        ("shape = [1, 2.5, 0, 4]", fixed([1.0, 2.5, 0.0, 4.0])),
        ("search = false\nshape = [1, 1, 1, 1]", fixed([1.0; 4])),
    ] {
        let text = format!("[[method]]\nname = \"a\"\nbasis = \"gt\"\nenergy = \"dirichlet\"\n{line}\n");
        assert_eq!(tensor(&methods(&text)[0]).0, &functions, "{line}");
    }
    // A swarm would find fifty thousand least areas.
    let text = "[[method]]\nname = \"a\"\nbasis = \"gt\"\nenergy = \"area\"\nsearch = true\n";
    assert_eq!(tensor(&methods(text)[0]).0, &gt(SearchMode::Polish, Energy::Area));
    let text = "[[method]]\nname = \"a\"\nenergy = \"area\"\nsearch = false\n";
    assert_eq!(tensor(&methods(text)[0]).0, &Functions::Bernstein);
}

#[test]
fn every_interior() {
    for (line, interior) in [
        ("energy = \"dirichlet\"", extremal(Functional::Dirichlet)),
        ("energy = \"laplacian\"", extremal(Functional::Laplacian)),
        ("energy = \"bending\"", extremal(Functional::Bending)),
        ("energy = \"coons\"", extremal(Functional::Coons)),
        ("energy = \"area\"", TensorInterior::LeastArea { tolerance: 1e-10, bound: false, layers: 0 }),
        (
            "energy = \"dirichlet\"\nmetric-steps = 2",
            TensorInterior::MetricCorrections { steps: 2, solver: SolverChoice::Auto },
        ),
        ("mask = -0.25", TensorInterior::Mask { alpha: -0.25 }),
        ("mask = 0", TensorInterior::Mask { alpha: 0.0 }),
        ("construction = \"discrete-coons\"", TensorInterior::DiscreteCoons),
        ("construction = \"harmonic\"", TensorInterior::Harmonic),
    ] {
        let method = &methods(&format!("[[method]]\nname = \"a\"\n{line}\n"))[0];
        assert_eq!(tensor(method), (&Functions::Bernstein, interior), "{line}");
    }
}

#[test]
fn what_a_search_minimises() {
    let energy = |lines: &str| {
        let text = format!("[[method]]\nname = \"a\"\nbasis = \"gt\"\nsearch = true\n{lines}\n");
        tensor(&methods(&text)[0]).0.searched().map(|(_, _, energy)| energy)
    };
    assert_eq!(energy("energy = \"bending\""), Some(Energy::Quadratic(Functional::Bending).into()));
    assert_eq!(energy("energy = \"bending\"\nsearch-energy = \"area\""), Some(Energy::Area.into()));
    let conformality = energy("energy = \"dirichlet\"\nsearch-energy = \"conformality\"");
    assert_eq!(conformality, Some(SearchEnergy::Conformality));
    assert_eq!(energy("construction = \"harmonic\""), Some(Energy::LAPLACIAN.into()));
    assert_eq!(
        energy("mask = 0.1\nsearch-energy = \"coons\""),
        Some(Energy::Quadratic(Functional::Coons).into())
    );
}

#[test]
fn tb_coons_needs_no_basis() {
    let text = "[[method]]\nname = \"a\"\npatch = \"tb-coons\"\nenergy = \"dirichlet\"\nsearch = \"polish\"\nraise = 2\n";
    let method = &methods(text)[0];
    assert_eq!((method.family(), method.raise()), (Family::Shaped(ShapedFamily::TbCoons), 2));
}

#[test]
fn solvers_and_the_local_variant() {
    let text = "[[method]]\nname = \"a\"\nenergy = \"dirichlet\"\nsolver = \"separable\"\n\
                [[method]]\nname = \"b\"\nmask = 0.1\nsolver = \"sparse\"\n\
                [search]\nvariant = \"local\"\nneighbours = 3\nbox = [0, 4]\n";
    let plan = plan(&format!("{NET}{text}"));
    let patches = patches(&plan);
    let separable =
        TensorInterior::Extremal { energy: Functional::Dirichlet, solver: SolverChoice::Separable };
    assert_eq!(tensor(&patches.methods[0]).1, separable);
    assert_eq!(tensor(&patches.methods[1]).1, TensorInterior::Mask { alpha: 0.1 });
    assert_eq!(patches.search.variant(), Variant::Local { neighbours: 3 });
    assert_eq!(patches.search.bounds(), [0.0, 4.0]);
}

#[test]
fn harmonic_nets_from_two_sides() {
    let rows = r#"
        title = "Rows"
        [boundary]
        u0 = [[0,0,0],[1,0,1],[2,0,0]]
        u1 = [[0,1,0],[1,1,1],[2,1,0]]
        u-degree = 4
        [[method]]
        name = "harmonic"
        construction = "harmonic"
    "#;
    let plan_of_rows = plan(rows);
    let direction = |plan: &Plan| match &patches(plan).boundary {
        Boundary::Opposite(sides) => sides.direction(),
        other => panic!("{other:?}"),
    };
    assert_eq!(direction(&plan_of_rows), Direction::Rows);
    assert_eq!(patches(&plan_of_rows).boundary.degrees(), (4, 2));
    let columns = plan(&rows.replace("u0", "v0").replace("u1", "v1").replace("u-degree", "v-degree"));
    assert_eq!(direction(&columns), Direction::Columns);
    assert_eq!(patches(&columns).boundary.degrees(), (2, 4));
    let method = "[[method]]\nname = \"a\"\nconstruction = \"harmonic\"\n";
    let all_four = plan(&format!("{}{method}", NET.replace("[boundary]", "[boundary]\nu-degree = 3")));
    assert!(matches!(patches(&all_four).boundary, Boundary::Tensor(_)));
}

#[test]
fn triangles() {
    let text = r#"
        title = "Triangle"
        [boundary]
        ab = [[1,0,0],[0.5,0.5,0],[0,1,0]]
        bc = [[0,1,0],[0,0.5,0.5],[0,0,1]]
        ca = [[0,0,1],[0.5,0,0.5],[1,0,0]]
        [[method]]
        name = "mask"
        mask = "coons"
        raise = 1
        [[method]]
        name = "Dirichlet mask"
        mask = "dirichlet"
        [[method]]
        name = "ninth"
        mask = 0.1111111111111111
    "#;
    let plan = plan(text);
    let patches = patches(&plan);
    assert!(matches!(patches.boundary, Boundary::Triangle(_)));
    assert_eq!(patches.boundary.degrees(), (2, 2));
    let masks = [TriangleMask::Coons, TriangleMask::Dirichlet, TriangleMask::Symmetric(1.0 / 9.0)];
    for (method, mask) in patches.methods.iter().zip(masks) {
        assert_eq!(method.filling(), &Filling::Triangle(TriangleInterior::Mask(mask)));
        assert_eq!(method.family(), Family::Triangle);
    }
}

#[test]
fn helicoids() {
    let text = r#"
        title = "Helicoid"
        [helicoid]                 # exact, AHT x AHT
        a = 1.0
        b = 2.0
        u-span = 1.5
        v-span = 6.0
        frames = 11                # optional: the deformation from (a,b) = (1,0) to (0,1)
        path = "trigonometric"     # or "linear"
    "#;
    let helicoid = |text: &str| match plan(text).experiment {
        Experiment::Helicoid(helicoid) => helicoid,
        other => panic!("{other:?}"),
    };
    let found = helicoid(text);
    assert_eq!((found.form().weights(), found.form().spans()), ([1.0, 2.0], [1.5, 6.0]));
    let path = DeformationPath::Trigonometric;
    assert_eq!((found.frames(), found.deformation().map(|d| d.path())), (11, Some(path)));
    let linear = helicoid(&text.replace("\"trigonometric\"", "\"linear\""));
    assert_eq!(linear.deformation().map(|d| d.path()), Some(DeformationPath::Linear));
    let outer = helicoid(&text.replace("path = \"trigonometric\"", "path-degree = 3\npath = \"bernstein\""));
    assert_eq!(outer.deformation().map(|d| d.path()), Some(DeformationPath::Bernstein { degree: 3 }));
    let long = helicoid(&text.replace("frames", "# ").replace("path", "# ").replace("6.0", "12"));
    assert_eq!((long.form().spans()[1], long.frames()), (12.0, 0));
}

#[test]
fn a_helicoid_over_a_trapezium() {
    let text = "title = \"T\"\n[trapezium-helicoid]   # exact, AT x degree 1\nspan = 3.9\ngamma = [6.2, 12.5]\nbeta = [1.0, 0.5]\n";
    let Experiment::TrapeziumHelicoid(found, Construction::EndpointRule) = plan(text).experiment else {
        panic!()
    };
    assert_eq!(found, surfaces::TrapeziumHelicoid::new(3.9, [6.2, 12.5], [1.0, 0.5]).unwrap());
    // Beyond 2π it is cut into several patches.
    assert!(matches!(plan(&text.replace("3.9", "12")).experiment, Experiment::TrapeziumHelicoid(..)));
}

#[test]
fn curves() {
    let text = r#"
        title = "Curve"
        [curve]
        basis = "gt"               # "bernstein" | "gt" | "aht" | "at"
        shape = [1.0, 2.0]         # gt
        points = [[0,0],[1,2],[3,2],[4,0]]
        samples = [0.0, 0.25, 1.0] # parameters in the basis' domain, or a count
    "#;
    let curve = |text: &str| match plan(text).experiment {
        Experiment::Curve(mut curves) if curves.len() == 1 => curves.remove(0),
        other => panic!("{other:?}"),
    };
    let found = curve(text);
    assert_eq!(found.basis(), CurveBasis::gt([1.0, 2.0]).unwrap());
    let second = surfaces::Point::new(1.0, 2.0, 0.0);
    assert_eq!((found.points()[1], found.points().len(), found.dimension()), (second, 4, 2));
    assert_eq!(found.samples(), [0.0, 0.25, 1.0]);

    let aht = curve(
        "title = \"x\"\n[curve]\nbasis = \"aht\"\nspan = 1.5\nsamples = 4\n\
         points = [[0,0,0],[1,2,0],[3,2,1],[4,0,0],[5,0,0],[6,1,0]]\n",
    );
    assert_eq!((aht.basis(), aht.dimension()), (CurveBasis::aht(1.5).unwrap(), 3));
    assert_eq!(aht.samples(), [0.0, 0.5, 1.0, 1.5]);
    let at = curve(
        "title = \"x\"\n[curve]\nbasis = \"at\"\nspan = 6.25\n\
         points = [[0,0],[1,2],[3,2],[4,0],[5,0],[6,1]]\n",
    );
    assert_eq!((at.basis(), at.samples().len()), (CurveBasis::at(6.25).unwrap(), 101));
    assert_eq!((at.samples()[0], at.samples()[100]), (0.0, 6.25));
}

#[test]
fn expected_numbers_keep_their_digits() {
    let text = format!(
        "{NET}[[method]]\nname = \"a\"\nbasis = \"gt\"\nenergy = \"dirichlet\"\nsearch = true\n\
         [method.expect]\ndirichlet = 37.4396\narea = 36.8\nshape = 0.8706\nbending = 100\n\
         search-minimum = {{ value = 37.44, tolerance = 1e-3 }}\nresidual = 1.5e-3\n\
         mean-curvature-max = 0.000\n"
    );
    let plan = plan(&text);
    let expect = &plan.wanted[0].expect;
    let of =
        |quantity| expect.iter().find(|e| e.quantity == quantity).unwrap_or_else(|| panic!("no {quantity}"));
    let dirichlet = of(Quantity::Dirichlet);
    assert_eq!((dirichlet.value, dirichlet.tolerance, dirichlet.line), (37.4396, 0.00005, 15));
    assert_eq!(dirichlet.text, "37.4396");
    assert!(dirichlet.is_met_by(37.439_561_2) && dirichlet.is_met_by(37.439_55));
    assert!(!dirichlet.is_met_by(37.439_54) && !dirichlet.is_met_by(37.4397));
    assert!(!dirichlet.is_met_by(f64::NAN) && !dirichlet.is_met_by(f64::INFINITY));
    assert_eq!(of(Quantity::Area).tolerance, 0.05);
    assert_eq!(of(Quantity::Bending).tolerance, 0.5);
    assert_eq!(of(Quantity::Residual).tolerance, 0.00005);
    assert_eq!(of(Quantity::MeanCurvatureMax).tolerance, 0.0005);
    let minimum = of(Quantity::SearchMinimum);
    assert_eq!((minimum.value, minimum.tolerance, minimum.text.as_str()), (37.44, 1e-3, "37.44"));
    for k in 0..4 {
        assert_eq!(of(Quantity::Shape(k)).value, 0.8706);
    }
    assert_eq!(expect.len(), 10);
}

#[test]
fn expected_lists_go_number_by_number() {
    let text = format!(
        "{NET}[[method]]\nname = \"a\"\nbasis = \"gt\"\nenergy = \"dirichlet\"\nsearch = true\n\
         expect.shape = [0.9, 0.91, 0.9, 1]\n"
    );
    let plan = plan(&text);
    let shape: Vec<(Quantity, f64, f64)> =
        plan.wanted[0].expect.iter().map(|e| (e.quantity, e.value, e.tolerance)).collect();
    assert_eq!(
        shape,
        [
            (Quantity::Shape(0), 0.9, 0.05),
            (Quantity::Shape(1), 0.91, 0.005),
            (Quantity::Shape(2), 0.9, 0.05),
            (Quantity::Shape(3), 1.0, 0.5)
        ]
    );
    let curve = "title = \"x\"\n[curve]\nbasis = \"bernstein\"\npoints = [[0,0],[1,0]]\nsamples = 2\n[expect]\ncurvature = 0.00\n";
    let wanted = Plan::parse("c.toml", curve).unwrap_or_else(|r| panic!("{r}")).wanted;
    assert_eq!((wanted.len(), wanted[0].expect.len()), (1, 2));
    assert_eq!(wanted[0].expect[1].quantity.to_string(), "curvature[1]");
}

#[test]
fn published_numbers_one_or_several() {
    let one = "[method.published]\nsource = \"GT Table 1\"\nquantity = \"dirichlet\"\nheading = \"Area\"\nprinted = 38.0000\nreason = \"copied\"\n";
    let several = format!("{}{}", one, one.replace("dirichlet", "shape").replace("38.0000", "0.8706"))
        .replace("[method.published]", "[[method.published]]");
    let method = "[[method]]\nname = \"a\"\nenergy = \"dirichlet\"\n";
    let found = &plan(&format!("{NET}{method}{one}")).wanted[0].published;
    assert_eq!(found.len(), 1);
    assert_eq!((found[0].printed, found[0].text.as_str(), found[0].tolerance), (38.0, "38.0000", 0.00005));
    assert_eq!((found[0].source.as_str(), found[0].quantity), ("GT Table 1", Quantity::Dirichlet));
    assert_eq!((found[0].heading.as_deref(), found[0].reason.as_deref()), (Some("Area"), Some("copied")));
    assert!(found[0].agrees_with(38.000_04) && !found[0].agrees_with(38.3538));
    let found = &plan(&format!("{NET}{method}{several}")).wanted[0].published;
    assert_eq!(found.len(), 2);
    assert_eq!((found[1].quantity, found[1].printed), (Quantity::Shape(0), 0.8706));
}

#[test]
fn output_formats_in_the_order_of_the_file() {
    let text = format!(
        "{NET}[[method]]\nname = \"a\"\nenergy = \"area\"\n[output]\nmesh = 2000\npictures = false\nstep-tolerance = 1e-3\nstep-unit = \"inch\"\nformats = [\"step\", \"obj\", \"step\"]\n"
    );
    assert_eq!(
        plan(&text).output,
        Output {
            mesh: 2000,
            formats: vec![Format::Step, Format::Obj],
            pictures: false,
            step: StepForm { tolerance: 1e-3, unit: Some(LengthUnit::Inch) }
        }
    );
}

#[test]
fn corners_that_differ_by_rounding_are_one_point() {
    // sin(2π) · 2, as a program writes it, where the other side has 0.
    let text = NET.replace("[6,0,0]]   # P_{0,j}", "[6,-4.898587196589413e-16,0]]");
    assert_ne!(text, NET);
    let plan = plan(&format!("{text}[[method]]\nname = \"a\"\nenergy = \"dirichlet\"\n"));
    let boundary = &patches(&plan).boundary;
    let Boundary::Tensor(sides) = boundary else { panic!("{boundary:?}") };
    assert_eq!(sides.sides()[0][3], sides.sides()[3][0]);
    assert_eq!(sides.welded(), 4.898587196589413e-16);
    let welded = Remark::from(boundary.welding().expect("it was welded"));
    let said = welded.to_string();
    assert!(said.contains("4.9e-16") && said.contains("made one point"), "{said}");
    let finished = run(&plan, Options::default(), &()).expect("it runs");
    assert!(finished.results.remarks().contains(&welded), "{:?}", finished.results.remarks());
    // A corner off by more than a millionth of the size is a slip.
    let off = NET.replace("[6,0,0]]   # P_{0,j}", "[6,1e-4,0]]");
    let method = "[[method]]\nname = \"a\"\nenergy = \"dirichlet\"\n";
    assert!(Plan::parse("off.toml", &format!("{off}{method}")).is_err());
}

fn film(text: &str) -> FilmExperiment {
    match plan(text).experiment {
        Experiment::Film(film) => film,
        other => panic!("no loops or faces: {other:?}"),
    }
}

fn loops(film: &FilmExperiment) -> &[Loop] {
    match &film.rim {
        Rim::Loops(loops) => loops,
        Rim::Faces(graph) => panic!("faces: {graph:?}"),
    }
}

const LEAST: &str = "[[method]]\nname = \"least area\"\nenergy = \"area\"\n";

#[test]
fn polygons_and_sides_are_loops() {
    let polygon = film(&format!(
        "title = \"x\"\n[boundary]\npolygon = [[0,0,0],[1,0,0],[1,1,0.5],[0,1,0]]\n{LEAST}degree = 8\nlayers = 0\n"
    ));
    let [around] = loops(&polygon) else { panic!("{polygon:?}") };
    assert_eq!(around.curves().len(), 4);
    assert_eq!(<[f64; 3]>::from(around.curves()[2].start()), [1.0, 1.0, 0.5]);
    let method = &polygon.methods[0];
    assert_eq!((method.energy, method.degree), (FillEnergy::Area, Some(8)));

    let sides = film(&format!(
        "title = \"x\"\n[boundary]\nsides = [[[0,0,0],[1,1,0],[2,0,0]],[[2,0,1e-9],[0,0,0]]]\n{}",
        LEAST.replace("area\"\n", "dirichlet\"\n")
    ));
    let [around] = loops(&sides) else { panic!("{sides:?}") };
    assert_eq!((around.curves().len(), around.welded()), (2, 1e-9));
    let method = &sides.methods[0];
    assert_eq!((method.energy, method.degree), (FillEnergy::Dirichlet, None));
}

#[test]
fn curves_of_every_form_make_loops() {
    let text = format!(
        r#"title = "x"
        boundary.loops = [["one", "-two", "three"]]
        [[curve]]
        name = "one"
        ends = ["a", "b"]
        points = [[0,0,0],[1,2,0],[2,0,0]]
        [[curve]]
        name = "two"
        ends = ["c", "b"]
        spline = {{ degree = 1, knots = [0, 0, 1, 2, 2], points = [[2,2,0],[3,1,0],[2,0,0]] }}
        [[curve]]
        name = "three"
        ends = ["c", "a"]
        circle = {{ center = [1,1,0], normal = [0,0,2], radius = 1.4142135623730951, from = [2,2,0], arc = [0, 180] }}
        {LEAST}"#
    );
    let film = film(&text);
    let [around] = loops(&film) else { panic!("{film:?}") };
    let places: Vec<[f64; 3]> = around.curves().iter().map(|c| c.start().into()).collect();
    for (place, expected) in places.iter().zip([[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0]]) {
        assert!(place.iter().zip(expected).all(|(x, y)| (x - y).abs() < 1e-15), "{places:?}");
    }
    // The arc runs to the left seen against its normal: over [0, 2, 0].
    let middle = <[f64; 3]>::from(around.curves()[2].point(0.5));
    assert!(middle.iter().zip([0.0, 2.0, 0.0]).all(|(x, y)| (x - y).abs() < 1e-14), "{middle:?}");
}

#[test]
fn closed_curves_close_by_themselves() {
    for form in [
        "polyline = [[0,0,0],[1,0,0],[0,1,0]]",
        "polyline = [[0,0,0],[1,0,0],[0,1,0],[0,0,0]]",
        "through = { points = [[0,0,0],[1,0,0],[0,1,0]] }",
        "circle = { center = [0,0,0], normal = [1,1,1], radius = 2 }",
        "points = [[0,0,0],[2,1,0],[-2,1,0],[0,0,0]]",
    ] {
        let film = film(&format!(
            "title = \"x\"\n[boundary]\nloops = [[\"c\"]]\n[[curve]]\nname = \"c\"\n{form}\n{LEAST}"
        ));
        let [around] = loops(&film) else { panic!("{film:?}") };
        assert!(around.curves()[0].is_closed() && around.welded() == 0.0, "{form}");
    }
}

#[test]
fn faces_between_curves() {
    let text = Template::Faces.text();
    let film = film(text);
    let Rim::Faces(graph) = &film.rim else { panic!("{film:?}") };
    assert_eq!((graph.curves().len(), graph.faces().len(), graph.names().len()), (6, 3, 5));
    assert!(["foot", "head", "south"].iter().all(|name| graph.names().iter().any(|n| n == name)));
    // A boundary without points may stand beside them.
    assert!(Plan::parse("f.toml", &text.replace("[output]", "[boundary]\n[output]")).is_ok());
    // Vertices in the middle of the faces, one that stays and one that only starts somewhere.
    for fixed in ["true", "false"] {
        let faces = text
            .replace("vertices = [\"foot\", \"south\", \"head\"]", "vertices = [\"foot\", \"south\", \"o\"]\n[[face]]\nvertices = [\"south\", \"head\", \"o\"]\n[[face]]\nvertices = [\"head\", \"foot\", \"o\"]");
        let vertex = format!("[[vertex]]\nname = \"o\"\npoint = [-0.2, -0.3, 1]\nfixed = {fixed}\n[output]");
        assert!(Plan::parse("f.toml", &faces.replace("[output]", &vertex)).is_ok());
    }
}

/// The surface of a text with one method.
fn surface(text: &str) -> Done {
    let finished = run(&plan(text), Options::default(), &()).expect("it runs");
    let [method] = <[_; 1]>::try_from(finished.results.into_methods()).expect("one method");
    *method.outcome.unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn loops_run_end_to_end() {
    // Six edges of a cube; 3K(¾)/(2K(¼)).
    let text = format!(
        "title = \"x\"\n[boundary]\npolygon = [[0,0,0],[1,0,0],[1,1,0],[1,1,1],[0,1,1],[0,0,1]]\n{LEAST}degree = 6\nexpect.area = 1.918892357\n"
    );
    let done = surface(&text);
    assert!((done.figures.area.value - 1.918_892_356_756_509).abs() < 1e-10, "{:?}", done.figures.area);
    let film = done.film.expect("a film");
    assert!(film.seams().kink.is_some_and(|kink| kink.max < 1e-5) && film.rim().largest < 1e-14);
    // Two circles of radius 1 at distance 0.6: the catenoid, and what both discs have.
    let rings = format!(
        "title = \"x\"\n[boundary]\nloops = [[\"low\"], [\"high\"]]\n\
         [[curve]]\nname = \"low\"\ncircle = {{ center = [0,0,0], normal = [0,0,1], radius = 1 }}\n\
         [[curve]]\nname = \"high\"\ncircle = {{ center = [0,0,0.6], normal = [0,0,1], radius = 1 }}\n{LEAST}degree = 8\n"
    );
    let done = surface(&rings);
    let discs = done.film.and_then(|film| film.one_by_one()).expect("two loops");
    assert!((discs - 2.0 * std::f64::consts::PI).abs() < 1e-6 && done.figures.area.value < discs, "{discs}");
}

#[test]
fn the_film_templates_show_every_key_of_their_tables() {
    let text = format!("{}{}", Template::Loops.text(), Template::Faces.text());
    for key in [
        "loops",
        "polygon",
        "sides",
        "name",
        "ends",
        "points",
        "polyline",
        "spline",
        "degree",
        "knots",
        "weights",
        "through",
        "tolerance",
        "circle",
        "center",
        "normal",
        "radius",
        "from",
        "arc",
        "vertices",
        "point",
        "fixed",
        "layers",
    ] {
        assert!(text.contains(&format!("{key} = ")) || text.contains(&format!("[curve.{key}]")), "{key}");
    }
}

#[test]
fn bilinear_nets_and_the_highest_degree_are_admitted() {
    let side = |fixed: &str, length: usize, along_u: bool| {
        let points: Vec<String> = (0..length)
            .map(|k| {
                let t = k as f64 / (length - 1) as f64;
                if along_u { format!("[{t}, {fixed}, 0]") } else { format!("[{fixed}, {t}, 0]") }
            })
            .collect();
        format!("[{}]", points.join(", "))
    };
    for (length, accepted) in [(2, true), (65, true), (66, false)] {
        let text = format!(
            "title = \"x\"\n[boundary]\nu0 = {}\nu1 = {}\nv0 = {}\nv1 = {}\n[[method]]\nname = \"a\"\nenergy = \"dirichlet\"\n",
            side("0", length, false),
            side("1", length, false),
            side("0", length, true),
            side("1", length, true),
        );
        assert_eq!(Plan::parse("n.toml", &text).is_ok(), accepted, "{length} points");
    }
}

#[test]
fn every_template_is_sound_and_explains_every_line() {
    for template in Template::ALL {
        let plan =
            Plan::parse(template.name(), template.text()).unwrap_or_else(|refusal| panic!("{refusal}"));
        assert_eq!(plan.stem, template.name());
        assert!(template.text().lines().all(|line| line.chars().count() <= 120), "{}", template.name());
        assert!(template.text().matches('#').count() >= 5, "{}", template.name());
        assert!(template.text().ends_with('\n') && !template.summary().is_empty());
    }
}

#[test]
fn the_tensor_template_shows_every_key_of_its_tables() {
    let text = Template::Tensor.text();
    for key in [
        "title",
        "seed",
        "u0",
        "u1",
        "v0",
        "v1",
        "name",
        "basis",
        "energy",
        "search",
        "shape",
        "search-energy",
        "raise",
        "metric-steps",
        "solver",
        "tolerance",
        "mask",
        "construction",
        "variant",
        "particles",
        "iterations",
        "runs",
        "inertia",
        "social",
        "cognitive",
        "box",
        "neighbours",
        "mesh",
        "formats",
        "pictures",
        "step-tolerance",
        "source",
        "quantity",
        "heading",
        "printed",
        "reason",
        "value",
        "tolerance",
    ] {
        assert!(text.contains(&format!("{key} = ")), "{key}");
    }
}

#[test]
fn no_file_name_leads_out_of_the_folder_of_results() {
    let text = format!("{NET}[[method]]\nname = \"a\"\nenergy = \"dirichlet\"\n");
    let names = ["...toml", "..toml", "..", ".", "", "a/..", "a/...toml", "/"];
    for name in names {
        assert_eq!(Plan::parse(name, &text).unwrap().stem, "experiment", "{name}");
    }
    assert_eq!(Plan::parse("....toml", &text).unwrap().stem, "...");
}
