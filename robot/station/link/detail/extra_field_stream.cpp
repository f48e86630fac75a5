// SPDX-License-Identifier: MIT
#include "robot/station/link/detail/extra_field_stream.h"

#include <utility>

namespace tiller {

std::shared_ptr<receive::Receiver> extraReceiver(const QString& host, std::uint16_t port, const Clock& clock,
                                                 const std::vector<std::string>& fields) {
    receive::ReceiverOptions options;
    options.host = host;
    options.port = port;
    options.clock = &clock;
    options.priority = 0;
    options.fields = fields;
    return std::make_shared<receive::Receiver>(options);
}

void ExtraFieldStream::follow(const QString& host, std::uint16_t port, const QStringList& fields) {
    end();
    if (fields.isEmpty()) {
        return;
    }
    std::vector<std::string> names;
    for (const QString& field : fields) {
        names.push_back(field.toStdString());
    }
    receiver_ = extraReceiver(host, port, clock_, names);
    stream_ = receiver_->subscribe();
    lost_ = 0;
    static_cast<void>(receiver_->start());  // cannot fail, because all fields are in the catalogue
}

void ExtraFieldStream::end() {
    stream_ = {};
    if (receiver_) {
        cleanup_.postCleanup([receiver = std::exchange(receiver_, nullptr)] { receiver->stop(); });
    }
}

SampleBatch ExtraFieldStream::drain(std::vector<receive::Sample>& into) {
    std::size_t count = 0;
    while (stream_.isValid()) {
        if (count == into.size()) {
            into.emplace_back();
        }
        if (!stream_.next(into[count])) {
            break;
        }
        ++count;
    }
    const std::uint64_t before = std::exchange(lost_, stream_.lost());
    return {std::span(into).first(count), lost_ - before};
}

QSet<QString> ExtraFieldStream::absent() const {
    QSet<QString> fields;
    if (receiver_) {
        for (const std::string& field : receiver_->absentFields()) {
            fields.insert(QString::fromStdString(field));
        }
    }
    return fields;
}

}  // namespace tiller
