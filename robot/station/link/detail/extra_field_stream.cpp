// SPDX-License-Identifier: MIT
#include "robot/station/link/detail/extra_field_stream.h"

#include <utility>

namespace tiller {

void ExtraFieldStream::follow(const QString& host, std::uint16_t port, const QStringList& fields) {
    end();
    if (fields.isEmpty()) {
        return;
    }
    receive::ReceiverOptions options;
    options.host = host;
    options.port = port;
    options.clock = &clock_;
    options.priority = 0;
    options.fields.clear();
    for (const QString& field : fields) {
        options.fields.push_back(field.toStdString());
    }
    receiver_ = std::make_shared<receive::Receiver>(options);
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
