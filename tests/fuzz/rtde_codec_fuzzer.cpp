// SPDX-License-Identifier: MIT
// Passes arbitrary bytes from the network to the splitter, all readers, the data codec and the client
// session. They must not read out of bounds or hang, and must be consistent with the writers.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "robot/rtde/codec.h"
#include "robot/rtde/session.h"
#include "robot/rtde/splitter.h"
#include "robot/rtde/values.h"

using namespace tiller;
using namespace tiller::rtde;

namespace {

void require(bool condition) {
    if (!condition) {
        std::abort();
    }
}

/// Takes values from the start of the input.
class Input {
public:
    explicit Input(ByteView bytes) : bytes_(bytes) {}
    std::uint8_t byte() {
        if (bytes_.empty()) {
            return 0;
        }
        const std::uint8_t value = bytes_.front();
        bytes_ = bytes_.subspan(1);
        return value;
    }
    ByteView take(std::size_t count) {
        const ByteView part = bytes_.first(std::min(count, bytes_.size()));
        bytes_ = bytes_.subspan(part.size());
        return part;
    }
    bool isEmpty() const { return bytes_.empty(); }

private:
    ByteView bytes_;
};

/// A written value must be read back unchanged.
template <class Write, class Read>
void comesBack(Write write, Read read) {
    Bytes out;
    write(out);
    PackageSplitter splitter;
    require(splitter.feed(out) == out.size());
    const auto package = splitter.next();
    require(package.has_value());
    require(read(package->payload));
}

void readEverything(const PackageView& package) {
    const ByteView payload = package.payload;
    require(packageTypeName(package.type) != nullptr);
    (void)readProtocolRequest(payload);
    (void)readAccepted(payload, package.type);
    if (const auto version = readVersionReply(payload)) {
        comesBack([&](Bytes& out) { writeVersionReply(out, *version); },
                  [&](ByteView again) { return readVersionReply(again).value() == *version; });
    }
    if (const auto text = readClientText(payload)) {
        comesBack([&](Bytes& out) { writeClientText(out, *text); },
                  [&](ByteView again) { return readClientText(again).value() == *text; });
    }
    for (const auto version : {ProtocolVersion::V1, ProtocolVersion::V2}) {
        (void)readControllerText(payload, version);
        if (const auto request = readSetupOutputsRequest(payload, version)) {
            require(request->names.size() <= payload.size() + 1);
        }
        if (const auto reply = readSetupOutputsReply(payload, version)) {
            comesBack(
                [&](Bytes& out) { writeSetupOutputsReply(out, version, reply->recipeId, reply->fields); },
                [&](ByteView again) {
                    return readSetupOutputsReply(again, version).value().fields == reply->fields;
                });
        }
        (void)readOutputData(payload, version);
    }
    (void)readSetupInputsRequest(payload);
    if (const auto reply = readSetupInputsReply(payload)) {
        comesBack(
            [&](Bytes& out) { writeSetupInputsReply(out, reply->recipeId, reply->fields); },
            [&](ByteView again) { return readSetupInputsReply(again).value().fields == reply->fields; });
    }
    (void)readInputData(payload);
}

/// Passes the stream to the splitter in pieces of arbitrary size and checks the packages.
void splitAnyhow(Input input) {
    const std::size_t limit = 3 + input.byte() * 16U;
    const std::size_t step = 1 + input.byte() % 40U;
    PackageSplitter splitter(limit);
    std::size_t taken = 0;
    std::size_t packages = 0;
    while (!input.isEmpty()) {
        ByteView piece = input.take(step);
        while (!piece.empty()) {
            const std::size_t count = splitter.feed(piece);
            taken += count;
            piece = piece.subspan(count);
            std::size_t progress = count;
            while (true) {
                const bool promised = splitter.hasNext();
                const auto package = splitter.next();
                require(package.has_value() == promised);
                if (!package) {
                    break;
                }
                require(package->payload.size() + kHeaderSize <= limit);
                readEverything(*package);
                ++packages;
                ++progress;
            }
            if (splitter.fault() != PackageSplitter::Fault::None) {
                require(splitter.error().code == ErrorCode::ProtocolError);
                return;
            }
            require(progress > 0);
        }
    }
    require(packages * kHeaderSize <= taken);
}

/// Decodes arbitrary bytes with arbitrary layouts, encodes the values, and decodes them again.
void codeValues(Input input) {
    std::vector<DataType> types;
    for (int i = input.byte() % 12; i > 0; --i) {
        types.push_back(static_cast<DataType>(input.byte() % 10));
    }
    const ValueLayout layout(types);
    const ByteView wire = input.take(layout.wireBytes() + 1);
    std::vector<double> values(layout.components());
    if (!decodeValues(layout, wire, values)) {
        require(wire.size() != layout.wireBytes());
        return;
    }
    Bytes again(layout.wireBytes());
    require(encodeValues(layout, values, again));
    std::vector<double> once(layout.components());
    require(decodeValues(layout, again, once));
    // The bytes may differ (BOOL 7 becomes 1, UINT64 above 2^53 is rounded), but the numbers must be equal.
    // NaN counts as equal to NaN.
    require(std::equal(values.begin(), values.end(), once.begin(),
                       [](double a, double b) { return a == b || (a != a && b != b); }));
}

void talkToSession(Input input) {
    SessionRequest request;
    const std::uint8_t shape = input.byte();
    if ((shape & 1) != 0) {
        request.outputs = {"timestamp", "actual_q", "robot_mode"};
    }
    for (int i = 0; i < ((shape >> 1) & 3); ++i) {
        request.inputs.push_back({{"input_int_register_24", "speed_slider_mask"}, (shape & 8) != 0});
    }
    request.frequency = static_cast<double>(static_cast<std::int8_t>(input.byte()));
    request.start = (shape & 16) != 0;
    Session session(request);
    Bytes out;
    session.begin(out);
    PackageSplitter splitter;
    while (!input.isEmpty()) {
        const std::uint8_t what = input.byte();
        if (what == 0xFE) {
            session.pause(out);
        } else if (what == 0xFF) {
            session.start(out);
        } else {
            // A framed package, so that the fuzzer need not find valid sizes.
            const ByteView payload = input.take(input.byte());
            static constexpr char kTypes[] = "VvMUOISP";
            session.handle({static_cast<PackageType>(what < 0xF0 ? kTypes[what % 8] : what), payload}, out);
        }
        require(session.isFailed() == (session.error().code != ErrorCode::None));
        require(session.period() > 0 && session.period() < 2);
        require(session.inputs().size() <= request.inputs.size());
        require(session.inputs().size() == session.inUse().size());
        require(session.texts().size() <= 32);
        if (session.isReady()) {
            require(session.inputs().size() == request.inputs.size());
            require(request.outputs.empty() || session.outputs().isValid());
        }
        (void)session.awaited();
    }
    // The output of the session must be a stream of complete packages.
    for (ByteView rest(out); !rest.empty();) {
        const std::size_t count = splitter.feed(rest);
        rest = rest.subspan(count);
        while (splitter.next()) {
        }
        require(splitter.fault() == PackageSplitter::Fault::None);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Input input(ByteView(data, size));
    switch (input.byte() % 3) {
        case 0:
            splitAnyhow(input);
            break;
        case 1:
            codeValues(input);
            break;
        default:
            talkToSession(input);
    }
    return 0;
}
