// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/hold/xcb_key_state_probe.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>
#include <xcb/xcb.h>
#include <xcb/xcbext.h>

#include <QCoreApplication>
#include <algorithm>
#include <cstdlib>
#include <memory>

#include "robot/core/clock.h"

namespace tiller {

namespace {

struct FreeReply {
    void operator()(void* reply) const { std::free(reply); }  // NOLINT: malloc()ed by the library
};
template <class Reply>
using Owned = std::unique_ptr<Reply, FreeReply>;

/// Returns true if the reply to a request has arrived. The reply is null if the server reported an error.
template <class Reply>
bool taken(xcb_connection_t* link, unsigned int request, Owned<Reply>& into) {
    void* reply = nullptr;
    xcb_generic_error_t* error = nullptr;
    if (xcb_poll_for_reply(link, request, &reply, &error) == 0) {
        return false;
    }
    into.reset(static_cast<Reply*>(reply));
    const Owned<xcb_generic_error_t> refused(error);
    return true;
}

}  // namespace

/// The connection to the display server, with at most one pending query.
class XcbKeyStateProbe::Link {
public:
    Link() : link_(xcb_connect(nullptr, nullptr)) {
        if (isAlive()) {
            root_ = xcb_setup_roots_iterator(xcb_get_setup(link_)).data->root;
        }
    }
    ~Link() { xcb_disconnect(link_); }
    Link(const Link&) = delete;
    Link& operator=(const Link&) = delete;

    bool isAlive() const { return xcb_connection_has_error(link_) == 0; }
    int descriptor() const { return xcb_get_file_descriptor(link_); }
    bool isAsking() const { return askedNs_ != 0; }
    std::int64_t askedNs() const { return askedNs_; }

    void ask(std::int64_t nowNs) {
        askedNs_ = nowNs;
        pointerRequest_ = xcb_query_pointer(link_, root_).sequence;
        keysRequest_ = xcb_query_keymap(link_).sequence;
        xcb_flush(link_);
    }
    /// Reads the received data. Returns true if both replies have arrived.
    bool answered(bool& button, std::array<bool, kKeys>& keys) {
        while (const Owned<xcb_generic_event_t> news{xcb_poll_for_event(link_)}) {
            // Discard all events, because none were selected.
        }
        if (!isAsking()) {
            return false;
        }
        // Read the second reply first, because each call reads the connection. If the first reply were read
        // first, and both replies arrived between the calls, the second call would put the first reply into
        // the queue of the library, and the thread would wait for data that the library has already read.
        if (!taken(link_, keysRequest_, keys_)) {
            return false;
        }
        taken(link_, pointerRequest_, pointer_);  // replies arrive in the order of the requests
        askedNs_ = 0;
        button = pointer_ != nullptr && (pointer_->mask & XCB_BUTTON_MASK_1) != 0;
        for (std::size_t code = 0; code < keys.size(); ++code) {
            keys.at(code) = keys_ != nullptr && ((keys_->keys[code / 8] >> (code % 8)) & 1) != 0;
        }
        return true;
    }

private:
    xcb_connection_t* link_;
    xcb_window_t root_ = 0;
    std::int64_t askedNs_ = 0;
    unsigned int pointerRequest_ = 0;
    unsigned int keysRequest_ = 0;
    Owned<xcb_query_pointer_reply_t> pointer_;
    Owned<xcb_query_keymap_reply_t> keys_;
};

XcbKeyStateProbe::XcbKeyStateProbe() {
    std::array<int, 2> ends{-1, -1};
    if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
        return;  // without the pipe, there is no thread and no check
    }
    wakeRead_ = ends[0];
    wakeWrite_ = ends[1];
    thread_ = std::thread([this] { run(); });
}

XcbKeyStateProbe::~XcbKeyStateProbe() {
    quit_ = true;
    wake();
    if (thread_.joinable()) {
        thread_.join();
    }
    if (wakeRead_ >= 0) {
        ::close(wakeRead_);
        ::close(wakeWrite_);
    }
}

void XcbKeyStateProbe::wake() {
    const char token = 0;
    [[maybe_unused]] const auto written = ::write(wakeWrite_, &token, 1);  // full: wake-ups are pending
}

void XcbKeyStateProbe::want(bool wanted) {
    if (wanted_.exchange(wanted) != wanted) {
        wake();
    }
}

void XcbKeyStateProbe::query() {
    once_ = true;
    wake();
}

KeyStateProbe::Word XcbKeyStateProbe::leftButton() const {
    const std::lock_guard lock(heard_);
    return {askedNs_, buttonNs_};
}

KeyStateProbe::Word XcbKeyStateProbe::key(KeyCode code) const {
    const std::lock_guard lock(heard_);
    return {askedNs_, code < kKeys ? keyNs_.at(code) : 0};
}

std::int64_t XcbKeyStateProbe::waitingNs() const {
    const std::int64_t since = waitingSinceNs_;
    return since == 0 ? 0 : SteadyClock::shared().nowNs() - since;
}

QString XcbKeyStateProbe::description() const {
    return isThere()
               ? QCoreApplication::translate("KeyStateProbe",
                                             "Key-state check active: Tiller checks with the display server "
                                             "every 10 ms whether the button or key is still pressed.")
               : QCoreApplication::translate(
                     "KeyStateProbe",
                     "Key-state check unavailable: Tiller could not open a second connection to the display "
                     "server. Tiller relies on window events to detect key releases.");
}

void XcbKeyStateProbe::note(std::int64_t askedNs, bool button, const std::array<bool, kKeys>& keys) {
    const std::lock_guard lock(heard_);
    askedNs_ = askedNs;
    buttonNs_ = button ? askedNs : buttonNs_;
    for (std::size_t code = 0; code < kKeys; ++code) {
        keyNs_.at(code) = keys.at(code) ? askedNs : keyNs_.at(code);
    }
}

void XcbKeyStateProbe::run() {
    const Clock& clock = SteadyClock::shared();
    Link link;
    if (!link.isAlive()) {
        return;
    }
    there_ = true;
    std::int64_t nextNs = 0;
    while (!quit_) {
        int timeoutMs = link.isAsking() ? kAskMs : -1;
        if (!link.isAsking() && (wanted_ || once_)) {
            const std::int64_t now = clock.nowNs();
            if (once_.exchange(false) || now >= nextNs) {
                nextNs = now + kAskMs * kNsPerMs;
                waitingSinceNs_ = now;
                link.ask(now);
            } else {
                timeoutMs = static_cast<int>((nextNs - now) / kNsPerMs) + 1;
            }
        }
        std::array<pollfd, 2> ends{{{wakeRead_, POLLIN, 0}, {link.descriptor(), POLLIN, 0}}};
        ::poll(ends.data(), ends.size(), timeoutMs);
        std::array<char, 64> tokens{};
        while (::read(wakeRead_, tokens.data(), tokens.size()) > 0) {
        }
        bool button = false;
        std::array<bool, kKeys> keys{};
        const std::int64_t asked = link.askedNs();
        if (link.answered(button, keys)) {
            note(asked, button, keys);
            waitingSinceNs_ = 0;
        }
        if (!link.isAlive()) {
            // The connection is lost, so no more replies will arrive. Report a waiting time of at least 1 s,
            // which ends every hold.
            waitingSinceNs_ = waitingSinceNs_ == 0 ? clock.nowNs() - kNsPerSecond : waitingSinceNs_.load();
            return;
        }
    }
}

}  // namespace tiller
