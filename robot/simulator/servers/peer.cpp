// SPDX-License-Identifier: MIT
#include "robot/simulator/servers/peer.h"

namespace tiller::simulator {

Peer::Peer(native_socket::Descriptor descriptor, std::size_t backlog)
    : descriptor_(descriptor), backlog_(backlog) {}

Peer::~Peer() {
    close();
}

void Peer::close() {
    if (open_) {
        open_ = false;
        native_socket::close(descriptor_);
    }
}

std::size_t Peer::receive(std::span<std::uint8_t> into) {
    if (!open_ || into.empty()) {
        return 0;
    }
    const native_socket::Transfer got = native_socket::receive(descriptor_, into);
    switch (got.status) {
        case native_socket::Status::Ok:
            return got.bytes;
        case native_socket::Status::WouldBlock:
            return 0;
        case native_socket::Status::Closed:
        case native_socket::Status::Failed:
            close();
            return 0;
    }
    return 0;
}

std::size_t Peer::sendNow(std::span<const std::uint8_t> bytes) {
    std::size_t done = 0;
    while (open_ && done < bytes.size()) {
        const native_socket::Transfer moved = native_socket::send(descriptor_, bytes.subspan(done));
        if (moved.status == native_socket::Status::Ok) {
            done += moved.bytes;
        } else if (moved.status == native_socket::Status::WouldBlock) {
            break;
        } else {
            close();
        }
    }
    return done;
}

bool Peer::send(std::span<const std::uint8_t> bytes) {
    if (!open_ || closing_) {
        return true;  // there is nobody to be told
    }
    flush();
    if (pending() > 0) {
        if (pending() + bytes.size() > backlog_) {
            return false;
        }
        out_.insert(out_.end(), bytes.begin(), bytes.end());
        return true;
    }
    const std::size_t gone = sendNow(bytes);
    out_.assign(bytes.begin() + static_cast<std::ptrdiff_t>(gone), bytes.end());
    sent_ = 0;
    return true;
}

bool Peer::send(std::string_view text) {
    return send({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

void Peer::flush() {
    if (pending() > 0) {
        sent_ += sendNow(std::span(out_).subspan(sent_));
    }
    if (pending() == 0) {
        out_.clear();
        sent_ = 0;
        if (closing_) {
            close();
        }
    }
}

void Peer::closeAfterFlush() {
    closing_ = true;
    flush();
}

}  // namespace tiller::simulator
