// SPDX-License-Identifier: MIT
#pragma once

// The two conveyor encoders of a controller. The counts come from pulses on the first four digital inputs or
// are set by a program. Source: URScript encoder_*.

#include <array>
#include <cstdint>

namespace tiller::simulator {

class Encoders {
public:
    static constexpr int kCount = 2;

    /// decoder  0 none, 1 quadrature, 2 both edges of A, 3 rising edges of A, 4 falling edges of A
    /// inputA, inputB  digital inputs 0..3
    void enablePulses(int encoder, int decoder, int inputA, int inputB);
    /// Lets the program set the count, which wraps around according to `range`: 0 int32, 1 uint8, 2 uint16, 3
    /// uint24, 4 uint32.
    void enableCount(int encoder, int range);
    void set(int encoder, double ticks);
    double ticks(int encoder) const { return at(encoder).ticks; }
    /// Count since the start, without wrap-around. A count set by a program while pulses are decoded does not
    /// change this value.
    double travel(int encoder) const { return at(encoder).travel; }
    /// The count as reported by RTDE.
    std::int32_t raw(int encoder) const;

    /// Runs one control period.
    /// conveyorSpeeds  simulated pulses, in addition to the digital inputs [ticks/s]
    void step(std::uint64_t digitalInputs, const std::array<double, 2>& conveyorSpeeds, double dt);

private:
    struct Encoder {
        int decoder = 0;
        int inputA = 0;
        int inputB = 1;
        unsigned lines = 0;    ///< previous levels of A and B
        bool counted = false;  ///< the count is set by the program
        double wrap = 0;       ///< number of ticks after which the count wraps around
        double least = 0;
        double ticks = 0;
        double travel = 0;
    };
    const Encoder& at(int encoder) const { return encoders_[static_cast<std::size_t>(encoder)]; }
    Encoder& at(int encoder) { return encoders_[static_cast<std::size_t>(encoder)]; }
    static double pulses(Encoder& encoder, std::uint64_t inputs);
    static double wrapped(const Encoder& encoder, double ticks);

    std::array<Encoder, kCount> encoders_;
};

}  // namespace tiller::simulator
