// SPDX-License-Identifier: MIT
//
// JSON in UDP datagrams, one for each sample.

#include <QHostAddress>
#include <QUdpSocket>
#include <memory>
#include <string>

#include "robot/live/detail/live_sinks.h"
#include "robot/live/detail/sample_json.h"

namespace tiller::live {

namespace {

class UdpSink final : public publish::SampleSink {
public:
    explicit UdpSink(const LiveSinkContext& context) : context_(context) {}

    Result<void> open() override {
        const LiveOptions& options = context_.options;
        if (!host_.setAddress(options.udpAddress)) {
            return Error{ErrorCode::AddressInvalid, QStringLiteral("send to %1").arg(options.udpAddress),
                         QStringLiteral("this is not an IP address; use an address such as 127.0.0.1")};
        }
        socket_ = std::make_unique<QUdpSocket>();
        return {};
    }

    Next take(const receive::Sample& sample, std::uint64_t) override {
        writeJson(sample, context_.options.fields, bytes_);
        const qint64 sent = socket_->writeDatagram(bytes_.data(), static_cast<qint64>(bytes_.size()), host_,
                                                   context_.options.udpPort);
        context_.counters->datagrams += sent > 0 ? 1 : 0;
        return Next::Continue;
    }

    void close() override { socket_.reset(); }

private:
    const LiveSinkContext context_;
    QHostAddress host_;
    std::unique_ptr<QUdpSocket> socket_;
    std::string bytes_;
};

}  // namespace

std::shared_ptr<publish::SampleSink> udpSink(const LiveSinkContext& context) {
    return context.options.udpAddress.isEmpty() ? nullptr : std::make_shared<UdpSink>(context);
}

}  // namespace tiller::live
