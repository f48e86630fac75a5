// SPDX-License-Identifier: MIT
// Whatever a dashboard server says, line by line, in answer to every command of the client: a value or an
// error, never a crash, never a hang. The bytes go through a real socket.

#include <QCoreApplication>
#include <cstddef>
#include <cstdint>
#include <mutex>

#include "robot/dashboard/detail/dashboard_commands.h"
#include "tests/support/raw_peer.h"

using namespace tiller;
using namespace tiller::dashboard;

namespace {

std::mutex mutex;
QByteArray replies;

/// Says everything at once: each command then finds its reply waiting.
void serve(test::RawPeer::Link& link) {
    QByteArray all;
    {
        const std::lock_guard lock(mutex);
        all = replies;
    }
    link.send("Connected\n" + all + "\n");
}

test::RawPeer& server() {
    static test::RawPeer peer(serve);
    return peer;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    {
        const std::lock_guard lock(mutex);
        replies = QByteArray(reinterpret_cast<const char*>(data), static_cast<qsizetype>(size));
    }
    DashboardClient client(QStringLiteral("127.0.0.1"), server().port());
    const auto soon = [] { return Deadline::after(std::chrono::milliseconds(200)); };
    if (!client.connect(soon())) {
        return 0;
    }
    (void)client.robotMode(soon());
    (void)client.safetyMode(soon());
    (void)client.isInRemoteControl(soon());
    (void)client.polyscopeVersion(soon());
    (void)client.serialNumber(soon());
    (void)client.robotModel(soon());
    (void)client.programState(soon());
    (void)client.play(soon());
    (void)isRunning(client, soon());
    (void)loadedProgram(client, soon());
    (void)isProgramSaved(client, soon());
    (void)safetyStatus(client, soon());
    (void)userRole(client, soon());
    (void)version(client, soon());
    (void)operationalMode(client, soon());
    (void)clearOperationalMode(client, soon());
    (void)generateSupportFile(client, QStringLiteral("."), soon());
    return 0;
}
