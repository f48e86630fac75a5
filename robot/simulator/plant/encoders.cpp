// SPDX-License-Identifier: MIT
#include "robot/simulator/plant/encoders.h"

#include <cmath>

namespace tiller::simulator {

namespace {

constexpr double kInt32Wrap = 4294967296.0;

unsigned lineAt(std::uint64_t inputs, int n) {
    return static_cast<unsigned>(inputs >> n & 1U);
}

}  // namespace

void Encoders::enablePulses(int encoder, int decoder, int inputA, int inputB) {
    Encoder& e = at(encoder);
    e.decoder = decoder;
    e.inputA = inputA;
    e.inputB = inputB;
    e.counted = false;
    e.wrap = kInt32Wrap;
    e.least = -0.5 * kInt32Wrap;
}

void Encoders::enableCount(int encoder, int range) {
    static constexpr std::array<double, 5> kWraps{kInt32Wrap, 256.0, 65536.0, 16777216.0, kInt32Wrap};
    Encoder& e = at(encoder);
    e.decoder = 0;
    e.counted = true;
    e.wrap = kWraps.at(static_cast<std::size_t>(range));
    e.least = range == 0 ? -0.5 * kInt32Wrap : 0.0;
    e.ticks = 0;
}

double Encoders::wrapped(const Encoder& e, double ticks) {
    return e.wrap > 0 ? ticks - e.wrap * std::floor((ticks - e.least) / e.wrap) : ticks;
}

void Encoders::set(int encoder, double ticks) {
    Encoder& e = at(encoder);
    if (e.counted) {
        e.travel += std::remainder(ticks - e.ticks, e.wrap);
    }
    e.ticks = wrapped(e, ticks);
}

std::int32_t Encoders::raw(int encoder) const {
    const double ticks = std::floor(at(encoder).ticks);
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::int64_t>(ticks)));
}

double Encoders::pulses(Encoder& e, std::uint64_t inputs) {
    const unsigned a = lineAt(inputs, e.inputA);
    const unsigned b = lineAt(inputs, e.inputB);
    const unsigned before = e.lines;
    e.lines = a | b << 1U;
    const unsigned wasA = before & 1U;
    switch (e.decoder) {
        case 1: {
            // Position in the quadrature sequence 00, 10, 11, 01 (A first). Only a change by one position
            // counts.
            const auto phase = [](unsigned lineA, unsigned lineB) { return (lineA ^ lineB) | lineB << 1U; };
            const unsigned moved = (phase(a, b) - phase(wasA, before >> 1U)) & 3U;
            return moved == 1 ? 1 : moved == 3 ? -1 : 0;
        }
        case 2:
            return a != wasA ? 1 : 0;
        case 3:
            return a > wasA ? 1 : 0;
        case 4:
            return a < wasA ? 1 : 0;
        default:
            return 0;
    }
}

void Encoders::step(std::uint64_t digitalInputs, const std::array<double, 2>& conveyorSpeeds, double dt) {
    for (int i = 0; i < kCount; ++i) {
        Encoder& e = at(i);
        if (e.decoder == 0) {
            continue;
        }
        // A decoder that cannot detect the direction always counts up.
        const double speed = conveyorSpeeds[static_cast<std::size_t>(i)];
        const double counted = pulses(e, digitalInputs) + (e.decoder == 1 ? speed : std::abs(speed)) * dt;
        e.travel += counted;
        e.ticks = wrapped(e, e.ticks + counted);
    }
}

}  // namespace tiller::simulator
