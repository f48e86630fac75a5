// SPDX-License-Identifier: MIT
#include <QTest>
#include <random>

#include "robot/rtde/codec.h"
#include "robot/rtde/splitter.h"

using namespace tiller;
using namespace tiller::rtde;

namespace {

struct Taken {
    PackageType type{};
    Bytes payload;
    friend bool operator==(const Taken&, const Taken&) = default;
};

std::vector<Taken> takeAll(PackageSplitter& splitter) {
    std::vector<Taken> out;
    while (const auto package = splitter.next()) {
        out.push_back({package->type, Bytes(package->payload.begin(), package->payload.end())});
    }
    return out;
}

/// Four packages of different kinds and sizes.
Bytes stream() {
    Bytes out;
    writeProtocolReply(out, true);
    writeVersionRequest(out);
    writeControllerText(out, ProtocolVersion::V2, {TextLevel::Info, "hello", "x"});
    writeStartReply(out, false);
    return out;
}

std::vector<Taken> expected() {
    PackageSplitter splitter;
    splitter.feed(stream());
    return takeAll(splitter);
}

}  // namespace

class TestSplitter : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void acceptsEverySegmentation();
    void acceptsSingleBytes();
    void acceptsRandomSegmentsOfALongStream();
    void reportsInvalidSizes_data();
    void reportsInvalidSizes();
    void packagesBeforeAnErrorAreReturned();
    void acceptsTheLargestPackage();
    void resumesAfterReset();
    void hasNextMatchesNext();
};

void TestSplitter::acceptsEverySegmentation() {
    const Bytes bytes = stream();
    QCOMPARE(expected().size(), std::size_t(4));
    // Tests all ways to cut the stream into three parts.
    for (std::size_t a = 0; a <= bytes.size(); ++a) {
        for (std::size_t b = a; b <= bytes.size(); ++b) {
            PackageSplitter splitter;
            std::vector<Taken> got;
            for (const ByteView part :
                 {ByteView(bytes).first(a), ByteView(bytes).subspan(a, b - a), ByteView(bytes).subspan(b)}) {
                QCOMPARE(splitter.feed(part), part.size());
                for (Taken& taken : takeAll(splitter)) {
                    got.push_back(std::move(taken));
                }
            }
            QVERIFY(got == expected());
        }
    }
}

void TestSplitter::acceptsSingleBytes() {
    PackageSplitter splitter;
    std::vector<Taken> got;
    for (const std::uint8_t byte : stream()) {
        splitter.feed(std::span(&byte, 1));
        for (Taken& taken : takeAll(splitter)) {
            got.push_back(std::move(taken));
        }
    }
    QVERIFY(got == expected());
}

void TestSplitter::acceptsRandomSegmentsOfALongStream() {
    // The stream is so long that the buffer wraps around many times.
    std::mt19937 random(1);
    Bytes bytes;
    std::vector<Bytes> payloads;
    for (int i = 0; i < 400; ++i) {
        Bytes payload(std::uniform_int_distribution<std::size_t>(0, 4000)(random));
        for (auto& byte : payload) {
            byte = static_cast<std::uint8_t>(random());
        }
        const std::size_t size = payload.size() + kHeaderSize;
        bytes.push_back(static_cast<std::uint8_t>(size >> 8));
        bytes.push_back(static_cast<std::uint8_t>(size & 0xFF));
        bytes.push_back('U');
        bytes.insert(bytes.end(), payload.begin(), payload.end());
        payloads.push_back(std::move(payload));
    }
    PackageSplitter splitter(4093);
    std::size_t at = 0;
    std::size_t seen = 0;
    while (at < bytes.size()) {
        const std::size_t wish = std::uniform_int_distribution<std::size_t>(1, 9000)(random);
        const std::size_t taken =
            splitter.feed(ByteView(bytes).subspan(at, std::min(wish, bytes.size() - at)));
        QVERIFY(taken > 0);
        at += taken;
        while (const auto package = splitter.next()) {
            QVERIFY(seen < payloads.size());
            QVERIFY(std::equal(package->payload.begin(), package->payload.end(), payloads[seen].begin(),
                               payloads[seen].end()));
            ++seen;
        }
    }
    QCOMPARE(seen, payloads.size());
    QCOMPARE(splitter.fault(), PackageSplitter::Fault::None);
}

void TestSplitter::reportsInvalidSizes_data() {
    QTest::addColumn<int>("size");
    QTest::addColumn<int>("limit");
    QTest::addColumn<int>("fault");
    const int small = static_cast<int>(PackageSplitter::Fault::TooSmall);
    const int large = static_cast<int>(PackageSplitter::Fault::TooLarge);
    QTest::newRow("0") << 0 << 65535 << small;
    QTest::newRow("1") << 1 << 65535 << small;
    QTest::newRow("2") << 2 << 65535 << small;
    QTest::newRow("above the limit") << 4094 << 4093 << large;
    QTest::newRow("text on the wrong port") << 0x5353 << 4093 << large;
}

void TestSplitter::reportsInvalidSizes() {
    QFETCH(int, size);
    QFETCH(int, limit);
    QFETCH(int, fault);
    PackageSplitter splitter(static_cast<std::size_t>(limit));
    const Bytes bytes{static_cast<std::uint8_t>(size >> 8), static_cast<std::uint8_t>(size & 0xFF), 'U', 0};
    splitter.feed(bytes);
    QVERIFY(!splitter.hasNext());
    QVERIFY(!splitter.next());
    QCOMPARE(static_cast<int>(splitter.fault()), fault);
    QCOMPARE(splitter.error().code, ErrorCode::ProtocolError);
    QVERIFY2(splitter.error().context.contains(QString::number(size)), qPrintable(splitter.error().context));
    // After an error, no further data are accepted.
    QCOMPARE(splitter.feed(stream()), std::size_t(0));
    QVERIFY(!splitter.next());
}

void TestSplitter::packagesBeforeAnErrorAreReturned() {
    PackageSplitter splitter;
    Bytes bytes = stream();
    bytes.insert(bytes.end(), {0, 1, 2});
    splitter.feed(bytes);
    QVERIFY(takeAll(splitter) == expected());
    QCOMPARE(splitter.fault(), PackageSplitter::Fault::TooSmall);
}

void TestSplitter::acceptsTheLargestPackage() {
    PackageSplitter splitter;
    Bytes bytes(kMaxPackageSize, 0x5A);
    bytes[0] = bytes[1] = 0xFF;
    bytes[2] = 'U';
    for (int i = 0; i < 3; ++i) {
        std::size_t at = 0;
        while (at < bytes.size()) {
            at += splitter.feed(ByteView(bytes).subspan(at));
        }
        const auto package = splitter.next();
        QVERIFY(package.has_value());
        QCOMPARE(package->payload.size(), kMaxPackageSize - kHeaderSize);
    }
}

void TestSplitter::resumesAfterReset() {
    PackageSplitter splitter;
    splitter.feed(Bytes{0, 0, 0});
    QVERIFY(!splitter.next());
    splitter.reset();
    QCOMPARE(splitter.fault(), PackageSplitter::Fault::None);
    QCOMPARE(splitter.error().code, ErrorCode::None);
    splitter.feed(stream());
    QVERIFY(takeAll(splitter) == expected());
}

void TestSplitter::hasNextMatchesNext() {
    const Bytes bytes = stream();
    PackageSplitter splitter;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        splitter.feed(ByteView(bytes).subspan(i, 1));
        const bool promised = splitter.hasNext();
        QCOMPARE(splitter.next().has_value(), promised);
    }
}

QTEST_GUILESS_MAIN(TestSplitter)
#include "tst_splitter.moc"
