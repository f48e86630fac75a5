// SPDX-License-Identifier: MIT
// Provokes each error code. The table is compared with the enumeration. A code without an entry is either
// unnecessary or lacks a test.
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <QDir>
#include <QTemporaryDir>
#include <map>

#include "robot/control/arm_queries.h"
#include "robot/control/motions.h"
#include "robot/control/programs.h"
#include "robot/core/tcp_connect.h"
#include "robot/dashboard/dashboard_client.h"
#include "robot/project/project_file.h"
#include "robot/receive/receiver.h"
#include "robot/recording/recorder.h"
#include "robot/rtde/connection.h"
#include "tests/integration/control/cell.h"
#include "tests/support/raw_peer.h"
#include "tests/support/rtde_peer.h"
#include "tests/support/waiting.h"

using namespace tiller;
using namespace tiller::control;
using namespace tiller::test;
using std::chrono::milliseconds;

namespace {

const QString kHere = QStringLiteral("127.0.0.1");

Error openRtde(int port, const Deadline& deadline, rtde::SessionRequest request = {}) {
    rtde::ConnectionOptions options;
    options.host = kHere;
    options.port = static_cast<std::uint16_t>(port);
    options.request = std::move(request);
    if (options.request.outputs.empty()) {
        options.request.outputs = {"timestamp"};
    }
    return rtde::Connection::open(options, deadline).error();
}

/// An open port that does not accept further connections: packets are dropped, as by a firewall.
class FullPort {
public:
    FullPort() : listening_(socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t length = sizeof address;
        bind(listening_, reinterpret_cast<sockaddr*>(&address), length);
        listen(listening_, 0);
        getsockname(listening_, reinterpret_cast<sockaddr*>(&address), &length);
        port_ = ntohs(address.sin_port);
        for (int& client : clients_) {
            client = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0);
            (void)connect(client, reinterpret_cast<sockaddr*>(&address), length);
        }
    }
    ~FullPort() {
        for (const int client : clients_) {
            close(client);
        }
        close(listening_);
    }
    FullPort(const FullPort&) = delete;
    FullPort& operator=(const FullPort&) = delete;
    int port() const { return port_; }

private:
    int listening_;
    int port_ = 0;
    std::array<int, 4> clients_{};
};

Error withoutDescriptors() {
    rlimit before{};
    getrlimit(RLIMIT_NOFILE, &before);
    // Set the limit just above the highest descriptor in use, and occupy all free descriptors below it.
    int highest = 0;
    for (const QString& entry : QDir(QStringLiteral("/proc/self/fd")).entryList(QDir::NoFilter)) {
        highest = std::max(highest, entry.toInt());
    }
    std::vector<int> plugs;
    rlimit none = before;
    none.rlim_cur = static_cast<rlim_t>(highest) + 1;
    setrlimit(RLIMIT_NOFILE, &none);
    for (int plug = dup(0); plug >= 0; plug = dup(0)) {
        plugs.push_back(plug);
    }
    const Error error = connectTcp(kHere, 1, testTimeout()).error();
    for (const int plug : plugs) {
        close(plug);
    }
    setrlimit(RLIMIT_NOFILE, &before);
    return error;
}

/// Runs `act` on a robot in control while time advances.
template <class Act>
Error inControl(Act act) {
    Cell cell;
    if (const auto taken = cell.takeControl(); !taken) {
        return taken.error();
    }
    return cell.during([&] { return act(*cell.controller); });
}

const std::map<ErrorCode, std::function<Error()>>& provocations() {
    static const std::map<ErrorCode, std::function<Error()>> table{
        {ErrorCode::AddressInvalid,
         [] { return connectTcp(QStringLiteral("no such host"), 1, testTimeout()).error(); }},
        {ErrorCode::HostUnreachable,
         [] {
             const FullPort port;
             return openRtde(port.port(), Deadline::after(milliseconds(100)));
         }},
        {ErrorCode::ConnectionRefused, [] { return openRtde(RawPeer::deadPort(), testTimeout()); }},
        {ErrorCode::ConnectionClosed,
         [] {
             RawPeer peer([](RawPeer::Link&) {});
             return openRtde(peer.port(), testTimeout());
         }},
        {ErrorCode::Timeout,
         [] {
             RawPeer peer([](RawPeer::Link& link) { link.beMute(); });
             return openRtde(peer.port(), Deadline::after(milliseconds(50)));
         }},
        {ErrorCode::Cancelled,
         [] {
             RawPeer peer([](RawPeer::Link& link) { link.beMute(); });
             const CancelToken token;
             std::thread impatient([&] {
                 while (peer.clients() == 0) {
                     std::this_thread::sleep_for(milliseconds(1));
                 }
                 token.cancel();
             });
             const Error error = openRtde(peer.port(), Deadline::never(token));
             impatient.join();
             return error;
         }},
        {ErrorCode::LinkLost,
         [] {
             VirtualClock clock;
             RtdePeer peer;
             receive::ReceiverOptions options;
             options.host = kHere;
             options.port = peer.port();
             options.clock = &clock;
             options.priority = 0;
             receive::Receiver receiver(options);
             receiver.start().value();
             peer.send(1.0);
             while (receiver.latest().isEmpty()) {
                 std::this_thread::sleep_for(milliseconds(1));
             }
             clock.advanceNs(10 * kNsPerSecond);
             while (receiver.state() == receive::ReceiverState::Receiving) {
                 std::this_thread::sleep_for(milliseconds(1));
             }
             return receiver.lastError();
         }},
        {ErrorCode::ProtocolError,
         [] {
             RawPeer peer([](RawPeer::Link& link) {
                 link.send(QByteArray(64, '\0'));
                 link.beMute();
             });
             return openRtde(peer.port(), testTimeout());
         }},
        {ErrorCode::VersionUnsupported,
         [] {
             return project::parseProject(R"({"format": "tiller-session", "version": 99, "waypoints": []})")
                 .error();
         }},
        {ErrorCode::FieldUnknown,
         [] {
             RtdePeerOptions robot;
             robot.missing = {"timestamp"};
             RtdePeer peer(robot);
             return openRtde(peer.port(), testTimeout());
         }},
        {ErrorCode::RegisterInUse,
         [] {
             RtdePeerOptions robot;
             robot.inUse = {"input_int_register_24"};
             RtdePeer peer(robot);
             rtde::SessionRequest request;
             request.inputs = {{{"input_int_register_24"}, true}};
             return openRtde(peer.port(), testTimeout(), request);
         }},
        {ErrorCode::NotConnected,
         [] { return dashboard::DashboardClient(kHere, 1).robotMode(testTimeout()).error(); }},
        {ErrorCode::NotInControl,
         [] {
             Cell cell;
             return Motions(*cell.controller).moveJ(cell.robot.truth().q, {0.5, 1.4}).error();
         }},
        {ErrorCode::UnsafeState,
         [] {
             Cell cell([](simulator::SimulatorOptions& o) { o.poweredOn = false; });
             return cell.takeControl().error();
         }},
        {ErrorCode::RemoteControlRequired,
         [] {
             Cell cell([](simulator::SimulatorOptions& o) {
                 o.remoteControl = false;
                 o.gateLocalControl = true;
             });
             return cell.takeControl().error();
         }},
        {ErrorCode::LimitExceeded,
         [] {
             return inControl([](Controller& c) {
                 return Motions(c).moveJ(JointPositions(), {100.0, 1.4}).error();
             });
         }},
        {ErrorCode::InvalidArgument,
         [] {
             return inControl([](Controller& c) {
                 return Motions(c).moveJ(JointPositions(90, 0, 0, 0, 0, 0), {0.5, 1.4}).error();
             });
         }},
        {ErrorCode::NoSolution,
         [] {
             return inControl([](Controller& c) {
                 return ArmQueries(c).inverseKinematics({3, 0, 0, 0, 0, 0}, {}, testTimeout()).error();
             });
         }},
        {ErrorCode::Stopped,
         [] {
             return inControl([](Controller& c) {
                 auto stream = Motions(c).startSpeedL({}, Holding::Free);
                 c.stop(StopCause::StopButton);
                 return stream->send({}).error();
             });
         }},
        {ErrorCode::Rejected,
         [] {
             RawPeer peer([](RawPeer::Link& link) {
                 link.send("Connected: Universal Robots Dashboard Server\n");
                 while (!link.readLine().isNull()) {
                     link.send("no\n");
                 }
             });
             dashboard::DashboardClient client(kHere, peer.port());
             const auto connected = client.connect(testTimeout());
             return connected ? client.powerOn(testTimeout()).error() : connected.error();
         }},
        {ErrorCode::ScriptError,
         [] {
             return inControl([](Controller& c) {
                 return Programs(c)
                     .startFunction(QStringLiteral("broken"), QStringLiteral("b = = 2"), testTimeout())
                     .error();
             });
         }},
        {ErrorCode::FileNotReadable,
         [] { return project::loadProject(QStringLiteral("/nonexistent/cell.tiller")).error(); }},
        {ErrorCode::FileNotWritable,
         [] {
             receive::Receiver receiver({});
             return recording::Recorder().start({QStringLiteral("/nonexistent/a.csv"), {}}, receiver).error();
         }},
        {ErrorCode::FileCorrupt, [] { return project::parseProject("{").error(); }},
        {ErrorCode::DiskFull,
         [] {
             receive::Receiver receiver({});
             return recording::Recorder().start({QStringLiteral("/dev/full"), {}}, receiver).error();
         }},
        {ErrorCode::Internal, &withoutDescriptors},
    };
    return table;
}

}  // namespace

class TestErrorCodes : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyCodeIsProvoked_data() {
        QTest::addColumn<int>("code");
        for (int code = 1; code <= static_cast<int>(ErrorCode::Internal); ++code) {
            QTest::newRow(qPrintable(errorCodeName(static_cast<ErrorCode>(code)))) << code;
        }
    }
    void everyCodeIsProvoked() {
        QFETCH(int, code);
        const auto found = provocations().find(static_cast<ErrorCode>(code));
        QVERIFY2(found != provocations().end(), "no test provokes this code");
        const Error error = found->second();
        QVERIFY2(error.code == found->first, qPrintable(error.toString()));
        QVERIFY2(!error.context.isEmpty(), "the error does not name the failed operation");
    }

    void internalIsTheLastCode() {
        // Values beyond the last code have the name of Internal. If a code is added after Internal, this
        // check fails, because the loop above would not cover the new code.
        const int last = static_cast<int>(ErrorCode::Internal);
        QCOMPARE(errorCodeName(static_cast<ErrorCode>(last + 1)), errorCodeName(ErrorCode::Internal));
    }
};

QTEST_GUILESS_MAIN(TestErrorCodes)
#include "tst_error_codes.moc"
