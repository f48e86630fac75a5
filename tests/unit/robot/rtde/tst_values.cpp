// SPDX-License-Identifier: MIT
#include <QTest>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "robot/rtde/values.h"

using namespace tiller::rtde;

class TestValues : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyTypeRoundTrips();
    void bytesAreBigEndian();
    void integersAreLimitedToTheirRange();
    void boolIsTrueForAnythingButZero();
    void wrongSizesAreRefusedAndChangeNothing();
    void dataPackageCarriesRecipeIdOrNot();
};

void TestValues::everyTypeRoundTrips() {
    const ValueLayout layout({DataType::Bool, DataType::UInt8, DataType::UInt32, DataType::UInt64,
                              DataType::Int32, DataType::Double, DataType::Vector3D, DataType::Vector6D,
                              DataType::Vector6Int32, DataType::Vector6UInt32});
    QCOMPARE(layout.wireBytes(), std::size_t(1 + 1 + 4 + 8 + 4 + 8 + 24 + 48 + 24 + 24));
    QCOMPARE(layout.components(), std::size_t(1 + 1 + 1 + 1 + 1 + 1 + 3 + 6 + 6 + 6));
    const std::vector<double> values{1,
                                     255,
                                     4294967295.0,
                                     9007199254740992.0,
                                     -2147483648.0,
                                     -0.1,
                                     1e-300,
                                     -1e300,
                                     0.3,
                                     0.1,
                                     0.2,
                                     0.3,
                                     0.4,
                                     0.5,
                                     std::numeric_limits<double>::denorm_min(),
                                     -1,
                                     2,
                                     -3,
                                     4,
                                     2147483647.0,
                                     -2147483648.0,
                                     0,
                                     1,
                                     2,
                                     3,
                                     4,
                                     4294967295.0};
    std::vector<std::uint8_t> wire(layout.wireBytes());
    QVERIFY(encodeValues(layout, values, wire));
    std::vector<double> back(layout.components(), -77);
    QVERIFY(decodeValues(layout, wire, back));
    QCOMPARE(back, values);
}

void TestValues::bytesAreBigEndian() {
    const ValueLayout layout({DataType::UInt32, DataType::Int32, DataType::UInt64, DataType::Double});
    const std::array<double, 4> values{0x01020304, -2, 0x0102030405, -2.5};
    std::vector<std::uint8_t> wire(layout.wireBytes());
    QVERIFY(encodeValues(layout, values, wire));
    const std::vector<std::uint8_t> expected{1, 2, 3, 4, 0xFF, 0xFF, 0xFF, 0xFE, 0, 0, 0, 1,
                                             2, 3, 4, 5, 0xC0, 0x04, 0,    0,    0, 0, 0, 0};
    QCOMPARE(wire, expected);
}

void TestValues::integersAreLimitedToTheirRange() {
    const ValueLayout layout({DataType::UInt8, DataType::UInt8, DataType::Int32, DataType::Int32,
                              DataType::UInt32, DataType::UInt64, DataType::Int32, DataType::UInt8});
    const std::array<double, 8> values{300, -1, 1e12, -1e12, -5, 1e30, std::nan(""), 1.6};
    std::vector<std::uint8_t> wire(layout.wireBytes());
    QVERIFY(encodeValues(layout, values, wire));
    std::array<double, 8> back{};
    QVERIFY(decodeValues(layout, wire, back));
    const std::array<double, 8> expected{255, 0, 2147483647.0, -2147483648.0, 0, 18446744073709551615.0,
                                         0,   2};
    QVERIFY(back == expected);
}

void TestValues::boolIsTrueForAnythingButZero() {
    const ValueLayout layout({DataType::Bool, DataType::Bool, DataType::Bool});
    const std::array<std::uint8_t, 3> wire{0, 1, 0x80};
    std::array<double, 3> back{};
    QVERIFY(decodeValues(layout, wire, back));
    QVERIFY((back == std::array<double, 3>{0, 1, 1}));
}

void TestValues::wrongSizesAreRefusedAndChangeNothing() {
    const ValueLayout layout({DataType::Double, DataType::Int32});
    for (const std::size_t size : {0U, 8U, 11U, 13U}) {
        const std::vector<std::uint8_t> wire(size, 0x40);
        std::array<double, 2> into{7, 7};
        QVERIFY(!decodeValues(layout, wire, into));
        QVERIFY((into == std::array<double, 2>{7, 7}));
    }
    const std::vector<std::uint8_t> wire(12);
    std::array<double, 1> tooFew{7};
    QVERIFY(!decodeValues(layout, wire, tooFew));
    QCOMPARE(tooFew[0], 7.0);

    std::vector<std::uint8_t> out(12, 0xAA);
    QVERIFY(!encodeValues(layout, tooFew, out));
    QVERIFY(!encodeValues(layout, std::array{1.0, 2.0}, std::span(out).first(11)));
    QCOMPARE(out, std::vector<std::uint8_t>(12, 0xAA));
    // The buffer has no space for the header and the recipe ID.
    QCOMPARE(writeDataPackage(out, 1, layout, std::array{1.0, 2.0}), std::size_t(0));
}

void TestValues::dataPackageCarriesRecipeIdOrNot() {
    const ValueLayout layout({DataType::UInt8});
    std::array<std::uint8_t, 8> out{};
    QCOMPARE(writeDataPackage(out, 9, layout, std::array{5.0}), std::size_t(5));
    QVERIFY((out == std::array<std::uint8_t, 8>{0, 5, 'U', 9, 5, 0, 0, 0}));
    auto view = readInputData(ByteView(out).subspan(3, 2));
    QVERIFY(view.has_value());
    QCOMPARE(int(view->recipeId), 9);
    QCOMPARE(view->values.size(), std::size_t(1));
    view = readOutputData(ByteView(out).subspan(3, 2), ProtocolVersion::V1);
    QCOMPARE(view->values.size(), std::size_t(2));
    QVERIFY(!readInputData({}).has_value());
    QVERIFY(!readOutputData({}, ProtocolVersion::V2).has_value());
}

QTEST_GUILESS_MAIN(TestValues)
#include "tst_values.moc"
