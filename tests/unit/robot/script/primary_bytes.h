// SPDX-License-Identifier: MIT
#pragma once

// Primary packages in the format of a controller, assembled from the interface description.

#include <QByteArray>
#include <bit>
#include <cstdint>
#include <initializer_list>

namespace tiller::test {

class Wire {
public:
    Wire& u8(int value) {
        bytes_.append(static_cast<char>(value));
        return *this;
    }
    Wire& u32(std::uint32_t value) {
        for (int shift = 24; shift >= 0; shift -= 8) {
            u8(static_cast<int>((value >> shift) & 0xff));
        }
        return *this;
    }
    Wire& i32(std::int32_t value) { return u32(static_cast<std::uint32_t>(value)); }
    Wire& u64(std::uint64_t value) {
        return u32(static_cast<std::uint32_t>(value >> 32)).u32(static_cast<std::uint32_t>(value));
    }
    Wire& f32(float value) { return u32(std::bit_cast<std::uint32_t>(value)); }
    Wire& f64(double value) { return u64(std::bit_cast<std::uint64_t>(value)); }
    Wire& text(const char* value) {
        bytes_.append(value);
        return *this;
    }
    Wire& zeros(int count) {
        bytes_.append(count, '\0');
        return *this;
    }
    Wire& raw(const QByteArray& value) {
        bytes_.append(value);
        return *this;
    }
    const QByteArray& bytes() const { return bytes_; }

private:
    QByteArray bytes_;
};

inline QByteArray package(int type, const QByteArray& body) {
    return Wire().u32(static_cast<std::uint32_t>(body.size() + 5)).u8(type).raw(body).bytes();
}

inline QByteArray message(int type, const QByteArray& body, int source = 0xfd) {
    return package(20, Wire().u64(123456).u8(source).u8(type).raw(body).bytes());
}

inline QByteArray versionMessage() {
    return message(
        3, Wire().u8(9).text("URControl").u8(5).u8(24).i32(1).i32(77).text("04-10-2025, 00:25:33").bytes(),
        0xfe);
}

inline QByteArray robotModeData(int robotMode, bool running) {
    return package(0, Wire()
                          .u64(25643784000)
                          .u8(1)
                          .u8(1)
                          .u8(1)
                          .u8(0)
                          .u8(0)
                          .u8(running ? 1 : 0)
                          .u8(0)
                          .u8(robotMode)
                          .u8(0)
                          .f64(0.97)
                          .f64(0)
                          .f64(1)
                          .u8(0)
                          .bytes());
}

inline QByteArray masterboardData(int safetyMode) {
    return package(3, Wire().zeros(60).u8(safetyMode).zeros(9).bytes());
}

inline QByteArray configurationData() {
    Wire body;
    for (int i = 0; i < 6; ++i) {
        body.f64(-6.2 - i).f64(6.2 + i);
    }
    for (int i = 0; i < 6; ++i) {
        body.f64(3.3).f64(40);
    }
    body.zeros(5 * 8);
    for (const double a : {0.0, -0.425, -0.3922, 0.0, 0.0, 0.0}) {
        body.f64(a);
    }
    for (const double d : {0.1625, 0.0, 0.0, 0.1333, 0.0997, 0.0996}) {
        body.f64(d);
    }
    body.zeros(6 * 8).zeros(6 * 8);
    return package(6, body.i32(6).i32(4).i32(1).i32(3).bytes());
}

inline QByteArray robotState(const QByteArray& subPackages) {
    return package(16, subPackages);
}

}  // namespace tiller::test
