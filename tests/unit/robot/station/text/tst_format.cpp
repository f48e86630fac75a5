// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <limits>

#include "robot/station/text/format.h"

using namespace tiller;

class TestFormat : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void numbersKeepTheirDigitsAndUseAMinusSign() {
        QCOMPARE(format::number(-143.5, 2), QStringLiteral("−143.50"));
        QCOMPARE(format::signedNumber(12.4, 2), QStringLiteral("+12.40"));
        QCOMPARE(format::number(12.4, 0), QStringLiteral("12"));
    }
    void zeroHasNoSign() {
        QCOMPARE(format::signedNumber(-0.001, 2), QStringLiteral("0.00"));
        QCOMPARE(format::signedNumber(0.0, 2), QStringLiteral("0.00"));
    }
    void nanIsShownAsADash() {
        QCOMPARE(format::number(std::numeric_limits<double>::quiet_NaN(), 2), QStringLiteral("–"));
        QCOMPARE(format::number(std::numeric_limits<double>::infinity(), 2), QStringLiteral("–"));
    }
    void hugeNumbersHaveAnExponent() {
        QCOMPARE(format::number(2.4e37, 3), QStringLiteral("2.4e37"));
        QCOMPARE(format::signedNumber(-1.23456789e15, 1), QStringLiteral("−1.234568e15"));
        QCOMPARE(format::number(9e14, 1), QStringLiteral("900000000000000.0"));
        QCOMPARE(format::exponential(-2e-9, 3), QStringLiteral("−2e−9"));
        QCOMPARE(format::exponential(1234, 2), QStringLiteral("1.2e3"));
        QCOMPARE(format::exponential(100, 1), QStringLiteral("1e2"));
        QCOMPARE(format::exponential(5, 3), QStringLiteral("5"));
        QCOMPARE(format::exponential(0, 3), QStringLiteral("0"));
    }
    void unitsAreConvertedAndShown() {
        QCOMPARE(format::degrees(-1.5401), QStringLiteral("−88.24°"));
        QCOMPARE(format::newtons(-9.81), QStringLiteral("−9.8 N"));
        QCOMPARE(format::newtonMetres(0.123), QStringLiteral("0.12 Nm"));
        QCOMPARE(format::amperes(1.2), QStringLiteral("1.200 A"));
        QCOMPARE(format::percent(0.35), QStringLiteral("35 %"));
        QCOMPARE(format::degreesPerSecond(1.0471976), QStringLiteral("60 °/s"));
    }
    void countsAreGroupedByThree() {
        const QChar gap(0x202F);
        QCOMPARE(format::grouped(96000), QStringLiteral("96") + gap + QStringLiteral("000"));
        QCOMPARE(format::grouped(1234567),
                 QStringLiteral("1") + gap + QStringLiteral("234") + gap + QStringLiteral("567"));
        QCOMPARE(format::grouped(999), QStringLiteral("999"));
        QCOMPARE(format::grouped(0), QStringLiteral("0"));
    }
    void durationsAndSizesAreReadable() {
        QCOMPARE(format::duration(192.9), QStringLiteral("00:03:12"));
        QCOMPARE(format::duration(36000), QStringLiteral("10:00:00"));
        QCOMPARE(format::duration(-1), QStringLiteral("00:00:00"));
        QCOMPARE(format::bytes(80'000'000'000), QStringLiteral("80 GB"));
        QCOMPARE(format::bytes(1'500'000), QStringLiteral("1.5 MB"));
        QCOMPARE(format::bytes(512), QStringLiteral("512 B"));
        QCOMPARE(format::bytes(-5), QStringLiteral("0 B"));
    }
};

QTEST_GUILESS_MAIN(TestFormat)
#include "tst_format.moc"
