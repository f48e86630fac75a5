// SPDX-License-Identifier: MIT
#pragma once

// The RTDE recipes of ur_rtde 1.5.8, as seen in its network traffic. Each list of names has a trailing comma.

#include <QByteArray>
#include <vector>

namespace tiller::test {

inline QByteArray registerNames(const QByteArray& prefix, int first, int count) {
    QByteArray list;
    for (int i = first; i < first + count; ++i) {
        list += prefix + QByteArray::number(i) + ',';
    }
    return list;
}
inline QByteArray inputInts(int first, int count) {
    return registerNames("input_int_register_", first, count);
}
inline QByteArray inputDoubles(int first, int count) {
    return registerNames("input_double_register_", first, count);
}

/// Outputs of the control interface.
/// offset  0, or 24 for the upper registers
inline QByteArray urRtdeControlOutputs(int offset = 0) {
    return "robot_status_bits,safety_status_bits,runtime_state," +
           registerNames("output_int_register_", offset, 3) +
           registerNames("output_double_register_", offset, 6);
}

/// The 20 input recipes of the control interface.
inline std::vector<QByteArray> urRtdeControlRecipes(int offset = 0) {
    const auto ints = [offset](int first, int count) { return inputInts(first + offset, count); };
    const auto doubles = [offset](int first, int count) { return inputDoubles(first + offset, count); };
    const QByteArray I0 = ints(0, 1);
    return {I0 + doubles(0, 8) + ints(1, 1),
            I0 + doubles(0, 11),
            ints(0, 8) + doubles(0, 18),
            I0,
            I0 + doubles(0, 9),
            I0 + doubles(0, 6),
            I0 + doubles(0, 4),
            I0 + doubles(0, 1),
            ints(0, 2),
            I0 + doubles(0, 14),
            I0,
            I0 + doubles(0, 12),
            I0 + doubles(0, 8),
            I0 + doubles(0, 14),
            ints(0, 2),
            I0 + doubles(0, 13),
            ints(0, 7) + doubles(0, 6),
            I0 + "external_force_torque,",
            ints(0, 2) + doubles(0, 7),
            I0 + doubles(0, 1) + ints(1, 1)};
}

/// The 16 input recipes of the I/O interface.
inline std::vector<QByteArray> urRtdeIoRecipes() {
    const QByteArray I23 = inputInts(23, 1);
    std::vector<QByteArray> recipes = {
        I23,
        I23 + "standard_digital_output_mask,standard_digital_output,",
        I23 + "tool_digital_output_mask,tool_digital_output,",
        I23 + "speed_slider_mask,speed_slider_fraction,",
        I23 +
            "standard_analog_output_mask,standard_analog_output_type,standard_analog_output_0,"
            "standard_analog_output_1,",
        I23 + "configurable_digital_output_mask,configurable_digital_output,"};
    for (int i = 18; i <= 22; ++i) {
        recipes.push_back(I23 + inputInts(i, 1));
    }
    for (int i = 18; i <= 22; ++i) {
        recipes.push_back(I23 + inputDoubles(i, 1));
    }
    return recipes;
}

}  // namespace tiller::test
