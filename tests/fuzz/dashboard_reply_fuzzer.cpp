// SPDX-License-Identifier: MIT
// Passes arbitrary replies of a dashboard server, line by line, to every command of the client. The result
// must be a value or an error, not a crash or a hang. The bytes are sent through a real socket.

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

/// Sends all replies at once, so that each command finds its reply.
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
