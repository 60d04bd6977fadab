#pragma once
/// Random valid impact cases: every law, every kind of support. One seed, one case: a case that fails is
/// repeated from its seed alone.

#include <cstdint>

#include "dashpad/impact/impact_case.hpp"

namespace dashpad::test {

/// Extreme ratios of everything: most of these impacts could not be built.
ImpactCase random_case(std::uint64_t seed);

/// A part of a body or a test head on the padding of a vehicle: masses of 0.5 to 50 kg at 0.5 to 15 m/s on 1
/// to 10 cm of foam. Laws 4 and 5 are the Ensolite cards, each parameter varied about its value.
ImpactCase ordinary_case(std::uint64_t seed);

/// A part of a body or a test head, half an inch to ten inches in radius, 0.5 to 20 kg at 1 to 15 m/s on 0.5
/// to 10 cm of foam on a rigid, linear or curved support. Each parameter of a law is within half of a usual
/// value, which for laws 4 and 5 is that of the Ensolite cards.
ImpactCase plausible_case(std::uint64_t seed);

/// Sound numbers of a foam by curves, in all combinations of its parts: form of the base curve, rate effect,
/// friction, unloading, recoil, lag and continuation.
Foam random_foam(std::uint64_t seed);
CrushableFoam random_crushable_foam(std::uint64_t seed);

/// A sphere or a flat disc, 0.5 to 20 kg at 1 to 10 m/s, on 1 to 10 cm of a foam by curves (one in three
/// stays crushed) on a rigid, linear or curved support.
ImpactCase foam_case(std::uint64_t seed);

/// A foam case on two to four layers of such foams, or linear ones (one in six), each a tenth to nine tenths
/// of the pad; none that a layer may not have.
ImpactCase layered_case(std::uint64_t seed);

/// An ordinary case with a nose of every other shape, one in three on a pad that ends before the nose does.
ImpactCase nose_case(std::uint64_t seed);

/// A foam case or an ordinary one on a support that crushes, is damped, carries a panel or has a free body
/// behind it, in all combinations, one in three under gravity.
ImpactCase moving_case(std::uint64_t seed);

/// A case of any law and nose on a support with any of all that a support may have: also preloads and gaps,
/// what earlier blows have left, a rigid one on a free body; some with a sheet, some struck again.
ImpactCase support_case(std::uint64_t seed);

}  // namespace dashpad::test
