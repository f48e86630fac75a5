// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the latency of jogging: from a press on a jog button to the first motion packet, and from the
// release to the stop packet. Uses the whole window including plots and 3D view. Loads one core unless
// --no-load is set. A relay between the application and the simulated controller adds time stamps; the
// results include the delay of the relay. Prints a table. Does not check limits.
//
//   jog_latency [--presses 200] [--no-load] [--json]

#include <poll.h>

#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QHostAddress>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMouseEvent>
#include <QTemporaryDir>
#include <QTextStream>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <mutex>
#include <thread>
#include <vector>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include "app/main_window.h"
#include "robot/simulator/simulator.h"
#include "widgets/hold/hold_to_run_button.h"
#include "widgets/jog/jog_column.h"

using namespace tiller;
using Time = std::chrono::steady_clock;

namespace {

constexpr auto kRobot = "127.0.7.3";
constexpr auto kRelay = "127.0.7.4";

/// Forwards data between the application and one port of the robot, and reads the RTDE packages of the
/// application.
class Relay {
public:
    explicit Relay(std::uint16_t port) : port_(port) {
        listener_ = ::socket(AF_INET, SOCK_STREAM, 0);
        const int on = 1;
        ::setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
        const sockaddr_in at = address(kRelay);
        if (::bind(listener_, reinterpret_cast<const sockaddr*>(&at), sizeof at) != 0 ||
            ::listen(listener_, 8) != 0) {
            qFatal("jog_latency: port %d of %s is in use", port, kRelay);
        }
        thread_ = std::thread([this] { run(); });
    }
    ~Relay() {
        quit_ = true;
        thread_.join();
        ::close(listener_);
    }
    /// Time of the first new command with motion [steady ns]. The next member is that of the first new
    /// command without motion.
    std::atomic<std::int64_t> beganNs{0};
    std::atomic<std::int64_t> endedNs{0};

private:
    struct Pair {
        int client;
        int robot;
        QByteArray inputs;
    };

    sockaddr_in address(const char* host) const {
        sockaddr_in at{};
        at.sin_family = AF_INET;
        at.sin_port = htons(port_);
        ::inet_pton(AF_INET, host, &at.sin_addr);
        return at;
    }
    static bool pass(int from, int to, QByteArray* copy) {
        char buffer[16384];
        const ssize_t n = ::recv(from, buffer, sizeof buffer, 0);
        if (n <= 0 || ::send(to, buffer, static_cast<std::size_t>(n), MSG_NOSIGNAL) != n) {
            return false;
        }
        if (copy != nullptr) {
            copy->append(buffer, static_cast<qsizetype>(n));
        }
        return true;
    }
    /// Reads data packages of the command recipe: sequence, epoch, kind, ... as big-endian int32.
    void read(QByteArray& inputs) {
        while (inputs.size() >= 3) {
            const auto byte = [&](qsizetype i) { return static_cast<std::uint8_t>(inputs[i]); };
            const int size = byte(0) << 8 | byte(1);
            if (size < 3 || inputs.size() < size) {
                return;
            }
            constexpr int kKindAt = 4 + 2 * 4;
            if (byte(2) == 'U' && size >= 4 + 9 * 4 + 18 * 8) {
                const int kind = byte(kKindAt) << 24 | byte(kKindAt + 1) << 16 | byte(kKindAt + 2) << 8 |
                                 byte(kKindAt + 3);
                const bool moves = kind != 0;
                if (moves != moving_) {
                    moving_ = moves;
                    (moves ? beganNs : endedNs) = Time::now().time_since_epoch().count();
                }
            }
            inputs.remove(0, size);
        }
    }
    void run() {
        std::vector<Pair> pairs;
        const int on = 1;
        while (!quit_) {
            std::vector<pollfd> watched{{listener_, POLLIN, 0}};
            for (const Pair& pair : pairs) {
                watched.push_back({pair.client, POLLIN, 0});
                watched.push_back({pair.robot, POLLIN, 0});
            }
            if (::poll(watched.data(), watched.size(), 50) <= 0) {
                continue;
            }
            for (std::size_t i = pairs.size(); i-- > 0;) {
                Pair& pair = pairs[i];
                bool alive = true;
                if (watched[1 + 2 * i].revents != 0) {
                    alive = pass(pair.client, pair.robot, &pair.inputs);
                    read(pair.inputs);
                }
                if (alive && watched[2 + 2 * i].revents != 0) {
                    alive = pass(pair.robot, pair.client, nullptr);
                }
                if (!alive) {
                    ::close(pair.client);
                    ::close(pair.robot);
                    pairs.erase(pairs.begin() + static_cast<std::ptrdiff_t>(i));
                }
            }
            if (watched[0].revents != 0) {
                const int client = ::accept(listener_, nullptr, nullptr);
                const int robot = ::socket(AF_INET, SOCK_STREAM, 0);
                const sockaddr_in at = address(kRobot);
                if (::connect(robot, reinterpret_cast<const sockaddr*>(&at), sizeof at) != 0) {
                    ::close(client);
                    ::close(robot);
                    continue;
                }
                ::setsockopt(client, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
                ::setsockopt(robot, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
                pairs.push_back({client, robot, {}});
            }
        }
        for (const Pair& pair : pairs) {
            ::close(pair.client);
            ::close(pair.robot);
        }
    }

    std::uint16_t port_;
    int listener_ = -1;
    std::atomic<bool> quit_{false};
    bool moving_ = false;
    std::thread thread_;
};

double percentile(std::vector<double> values, double percent) {
    if (values.empty()) {
        return 0;
    }
    std::sort(values.begin(), values.end());
    const double at = percent / 100.0 * static_cast<double>(values.size() - 1);
    return values[static_cast<std::size_t>(std::lround(at))];
}

/// Runs the event loop for this time or until the condition is true.
template <class Condition>
bool spin(int ms, Condition condition) {
    QElapsedTimer time;
    time.start();
    while (time.elapsed() < ms) {
        if (condition()) {
            return true;
        }
        QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
    }
    return condition();
}

void mouse(QWidget& key, QEvent::Type type) {
    const QPointF at = QRectF(key.rect()).center();
    const bool down = type == QEvent::MouseButtonPress;
    // Post the event like a window system does, so that it is processed after pending paint events.
    QCoreApplication::postEvent(
        &key, new QMouseEvent(type, at, key.mapToGlobal(at), Qt::LeftButton,
                              down ? Qt::MouseButtons(Qt::LeftButton) : Qt::NoButton, Qt::NoModifier));
}

}  // namespace

int main(int argc, char* argv[]) {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    QApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOptions({{"presses", "Number of presses.", "n", "200"},
                       {"no-load", "Do not load a core."},
                       {"json", "Print a JSON object instead of a table."}});
    parser.process(application);

    simulator::SimulatorOptions options;
    options.listenAddress = QString::fromLatin1(kRobot);
    options.poweredOn = true;
    options.priority = 95;
    simulator::Simulator robot(options);
    QTextStream err(stderr);
    if (const Result<void> started = robot.start(); !started) {
        err << started.error().toString() << '\n';
        return 1;
    }
    std::vector<std::unique_ptr<Relay>> others;
    for (const std::uint16_t port : std::array<std::uint16_t, 4>{29999, 30001, 30002, 30003}) {
        others.push_back(std::make_unique<Relay>(port));
    }
    Relay rtde(30004);

    QTemporaryDir folder;
    app::MainWindow window{app::Settings(folder.filePath("settings.ini"))};
    window.resize(1920, 1080);
    window.show();
    window.activateWindow();
    window.connectRobot({"Benchmark", QString::fromLatin1(kRelay), 0, true});
    RobotSession& session = window.session();
    if (!spin(10'000, [&] { return session.state().link == LinkState::Live && window.isActiveWindow(); })) {
        err << "no data: " << session.state().linkReason << '\n';
        return 1;
    }
    session.takeControl();
    if (!spin(10'000, [&] { return session.state().canMove(); })) {
        err << "not in control: " << session.state().controlReason << '\n';
        return 1;
    }
    std::atomic<bool> quit{false};
    std::thread load;
    if (!parser.isSet("no-load")) {
        load = std::thread([&quit] {
            volatile double x = 1;
            while (!quit) {
                x = std::sqrt(x + 1);
            }
        });
    }
    // Wait until the plots have some history to draw.
    spin(3000, [] { return false; });

    std::vector<double> pressMs;
    std::vector<double> releaseMs;
    int lost = 0;
    int frames = 0;
    QObject::connect(&session, &RobotSession::stateChanged, &window, [&frames] { ++frames; });
    QElapsedTimer whole;
    whole.start();
    const int presses = parser.value("presses").toInt();
    for (int i = 0; i < presses; ++i) {
        auto* key = window.findChild<HoldToRunButton*>(i % 2 == 0 ? "jog.X+" : "jog.X-");
        const auto now = [] { return Time::now().time_since_epoch().count(); };
        const std::int64_t pressed = now();
        mouse(*key, QEvent::MouseButtonPress);
        const bool began = spin(500, [&] { return rtde.beganNs > pressed; });
        // The waits have different phases within a frame and within a control period.
        spin(120 + i * 7 % 31, [] { return false; });
        const std::int64_t released = now();
        mouse(*key, QEvent::MouseButtonRelease);
        const bool ended = spin(500, [&] { return rtde.endedNs > released; });
        if (began && ended) {
            pressMs.push_back(static_cast<double>(rtde.beganNs - pressed) / 1e6);
            releaseMs.push_back(static_cast<double>(rtde.endedNs - released) / 1e6);
        } else {
            ++lost;
        }
        spin(150 + i * 11 % 29, [] { return false; });
    }
    const double rate = frames * 1e3 / static_cast<double>(whole.elapsed());
    quit = true;
    if (load.joinable()) {
        load.join();
    }
    session.shutDown();

    QTextStream out(stdout);
    if (parser.isSet("json")) {
        const auto row = [](const std::vector<double>& v) {
            return QJsonObject{
                {"p50", percentile(v, 50)}, {"p99", percentile(v, 99)}, {"max", percentile(v, 100)}};
        };
        out << QJsonDocument(QJsonObject{{"press_to_motion_ms", row(pressMs)},
                                         {"release_to_stop_ms", row(releaseMs)},
                                         {"presses", static_cast<int>(pressMs.size())},
                                         {"not_seen", lost},
                                         {"interface_fps", rate}})
                   .toJson();
        return 0;
    }
    const auto row = [&out](const char* name, const std::vector<double>& v) {
        out << QStringLiteral("%1 %2 %3 %4 %5\n")
                   .arg(QLatin1String(name), -32)
                   .arg(percentile(v, 50), 8, 'f', 2)
                   .arg(percentile(v, 90), 8, 'f', 2)
                   .arg(percentile(v, 99), 8, 'f', 2)
                   .arg(percentile(v, 100), 8, 'f', 2);
    };
    out << QStringLiteral("%1 presses, %2 not seen, interface at %3 frames a second\n")
               .arg(pressMs.size())
               .arg(lost)
               .arg(rate, 0, 'f', 1)
        << "ms                                    p50      p90      p99      max\n";
    row("press to first motion packet", pressMs);
    row("release to stop packet", releaseMs);
    return 0;
}
