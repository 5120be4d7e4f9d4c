//! Models that must be the same for some of their parameters.

use microbrdf_reference::fresnel::{Index, conductor, dielectric};
use microbrdf_reference::models::microfacet::{Attenuation, Distribution, Facet};
use microbrdf_reference::models::*;
use microbrdf_reference::sampling::Random;
use microbrdf_reference::{Brdf, Direction, Energy};

/// Both models over random pairs, near and far from the mirror direction.
fn same(a: &dyn Brdf, b: &dyn Brdf, tolerance: f64) {
    let mut random = Random::new(11);
    let mut lit = 0;
    for i in 0..3000 {
        let l = Direction::from_cosine(random.uniform(), 6.3 * random.uniform());
        let v = if i % 2 == 0 {
            Direction::from_cosine(random.uniform(), 6.3 * random.uniform())
        } else {
            let (r, s) = (l.mirrored(), 0.3 * random.uniform());
            let step = |x: f64, u: f64| x + s * (u - 0.5);
            let d = Direction::new(
                step(r.x, random.uniform()),
                step(r.y, random.uniform()),
                step(r.z, random.uniform()).abs(),
            );
            d.normalised()
        };
        for k in 0..3 {
            let (x, y) = (a.eval_rgb(&l, &v)[k], b.eval_rgb(&l, &v)[k]);
            assert!(
                (x - y).abs() <= tolerance * x.abs().max(y.abs()).max(1e-300),
                "{x} {y}"
            );
            lit += usize::from(x > 0.0);
        }
    }
    assert!(lit > 100);
}

#[test]
fn p_0_is_phong_and_p_1_metallic() {
    for n in [0.5, 3.0, 100.0] {
        let p = |p| PModel::new(n, p, Energy::Published).unwrap();
        same(&p(0.0), &Phong::new(n).unwrap(), 1e-15);
        same(
            &p(1.0),
            &MetallicPhong::new(n, Energy::Published).unwrap(),
            1e-15,
        );
    }
    same(
        &BisectorPhong::new(8.0, Bisector::Maximum).unwrap(),
        &MetallicPhong::new(8.0, Energy::Published).unwrap(),
        1e-8,
    );
    let large = BisectorPhong::unchecked(8.0, Bisector::PowerMean(100.0)).unwrap();
    let (l, v) = (
        Direction::from_degrees(60.0, 0.0),
        Direction::from_degrees(40.0, 180.0),
    );
    let metallic = MetallicPhong::new(8.0, Energy::Published).unwrap();
    assert!((large.eval(&l, &v) / metallic.eval(&l, &v) - 1.0).abs() < 0.01);
}

#[test]
fn ward_with_equal_widths_is_isotropic() {
    for m in [0.05, 0.2, 0.6] {
        same(
            &WardAnisotropic::new(m, m).unwrap(),
            &Ward::new(m).unwrap(),
            1e-11,
        );
    }
    same(
        &WardCorrected::anisotropic(0.2, 0.2).unwrap(),
        &WardCorrected::new(0.2).unwrap(),
        1e-12,
    );
}

#[test]
fn a_conductor_without_absorption_is_a_dielectric() {
    for eta in [0.7, 1.3, 1.5, 2.4] {
        for i in 0..=100 {
            let c = f64::from(i) / 100.0;
            assert!((conductor(eta, 0.0, c) - dielectric(eta, c)).abs() < 2e-15);
        }
        let grey = Metal::from_indices(9.0, [eta; 3], [0.0; 3]).unwrap();
        let index = Index::new(eta, 0.0).unwrap();
        let plastic = PlasticFresnel::new([0.0; 3], [1.0; 3], 9.0, index).unwrap();
        same(&grey, &plastic, 1e-12);
    }
}

#[test]
fn sharpness_0_is_lambert() {
    let lambert = Lambert::grey(1.0).unwrap();
    same(&PatchExponential::new(0.0).unwrap(), &lambert, 1e-15);
    same(&PatchExponential::new(1e-9).unwrap(), &lambert, 1e-8);
    same(&ToblerExponential::new(0.0).unwrap(), &lambert, 1e-15);
    same(&ToblerExponential::new(1e-9).unwrap(), &lambert, 1e-8);
    same(&Patch::new(2.0).unwrap(), &lambert, 1e-15);
    same(&GeneralisedLambert::new(0.0, 1.9).unwrap(), &lambert, 1e-9);
    same(&OrenNayar::new(1.0, 0.0).unwrap(), &lambert, 1e-15);
    same(&OrenNayarFull::new(1.0, 0.0).unwrap(), &lambert, 1e-15);
    same(&Minnaert::new(0.0).unwrap(), &lambert, 1e-15);
    let nothing = Lacquer::new(lambert, [0.0; 3], None).unwrap();
    same(&nothing, &lambert, 1e-15);
}

#[test]
fn patches_in_other_metrics_join_the_round_one() {
    for r in [0.3, 0.9, 1.5] {
        let round = Patch::new(r).unwrap();
        same(&PatchElliptic::new(r, 1.0).unwrap(), &round, 1e-12);
        same(&PatchPNorm::new(r, 1.0, 2.0).unwrap(), &round, 1e-10);
    }
    same(
        &PatchPower::new(0.0).unwrap(),
        &Patch::new(1.0).unwrap(),
        1e-15,
    );
    let exponential = PatchExponential::new(7.0).unwrap();
    let profile = PatchProfile::new(|m: f64| (-7.0 * m).exp(), Metric::EUCLIDEAN).unwrap();
    same(&profile, &exponential, 1e-11);
    let mixture = PatchMixture::new(
        |r| exponential.density(r),
        0.0,
        exponential.diffuse_weight(),
    )
    .unwrap();
    same(&mixture, &exponential, 1e-7);
}

#[test]
fn a_single_size_of_patch_is_the_basic_patch() {
    // A narrow density around R = 0.5, seen outside of its width.
    let narrow = |r: f64| if (r - 0.5).abs() < 1e-3 { 500.0 } else { 0.0 };
    let mixture = PatchMixture::new(narrow, 0.0, 0.0).unwrap();
    let patch = Patch::new(0.5).unwrap();
    let n = Direction::NORMAL;
    for m in [0.1, 0.45, 0.55, 0.9] {
        let v = Direction::new(m, 0.0, (1.0f64 - m * m).sqrt());
        let (a, b) = (mixture.eval(&n, &v), patch.eval(&n, &v));
        assert!((a - b).abs() < 1e-2 * b.max(1e-9), "{m}: {a} {b}");
    }
}

#[test]
fn microfacet_models_join() {
    let d = Distribution::trowbridge(0.3).unwrap();
    same(
        &CookTorrance::new(d, Attenuation::Smith, Facet::White).unwrap(),
        &Ggx::new(0.3, Facet::White).unwrap(),
        1e-15,
    );
    let blinn = Distribution::blinn(25.0).unwrap();
    same(
        &CookTorrance::new(blinn, Attenuation::VCavity, Facet::White).unwrap(),
        &TorranceSparrow::blinn(25.0, Facet::White).unwrap(),
        1e-15,
    );
}

#[test]
fn pumping_no_times_changes_nothing() {
    let phong = Phong::new(20.0).unwrap();
    same(
        &Pumped::with_cells(phong, PumpRule::Full, 0, 32).unwrap(),
        &phong,
        0.0,
    );
}

#[test]
fn lobes_of_equal_weights_are_phongs() {
    same(
        &AnisotropicPhong::new([1.0; 3], 12.0, 0.0).unwrap(),
        &Phong::new(12.0).unwrap(),
        1e-8,
    );
    same(
        &Lafortune::phong(12.0).unwrap(),
        &Phong::new(12.0).unwrap(),
        1e-9,
    );
}
