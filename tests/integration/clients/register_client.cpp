// SPDX-License-Identifier: MIT
#include "tests/integration/clients/register_client.h"

#include <QRegularExpression>

#include "tests/support/ur_rtde_recipes.h"

namespace tiller::test {

namespace {

constexpr quint32 kStopped = 1;
constexpr quint32 kPlaying = 2;
constexpr quint32 kProtectiveStop = 2;
constexpr quint32 kEmergencyStop = 7;

}  // namespace

bool RegisterClient::connect() {
    const auto ports = robot_.controller.ports();
    dashboard_ = std::make_unique<RawDashboard>(robot_.host(), ports.dashboard);
    if (dashboard_->greeting.isEmpty()) {
        return fail("greeting");
    }
    static const QRegularExpression number("\\d+\\.\\d+\\.\\d+\\.\\d+");
    const auto version = [this] {
        return number.match(QString::fromLatin1(dashboard_->ask("PolyscopeVersion"))).captured();
    };
    const QString software = version();
    if (software.isEmpty()) {
        return fail("PolyscopeVersion");
    }
    const int major = software.section('.', 0, 0).toInt();
    const int minor = software.section('.', 1, 1).toInt();
    if (major == 5 && minor > 5) {
        version();
        static const QRegularExpression digits("^\\d+$");
        if (!digits.match(QString::fromLatin1(dashboard_->ask("get serial number").chopped(1))).hasMatch()) {
            return fail("serial number");
        }
        // ur_rtde skips the query for 127.0.0.1. The tests always send it, as for a robot on a network.
        version();
        if (!dashboard_->ask("is in remote control").contains("true")) {
            return fail("remote control");
        }
    }
    rtde_ = std::make_unique<RawRtde>(robot_.host(), ports.rtde);
    rtde_->request('V', bigEndian(quint16(2)));
    const auto askVersion = [this] {
        const auto reply = rtde_->request('v');
        return reply.type == 'v' && reply.payload.size() == 16;
    };
    if (!askVersion()) {
        return fail("version");
    }
    script_ = std::make_unique<RawClient>(robot_.host(), ports.realtime);
    if (!script_->isConnected()) {
        return fail("script socket");
    }
    if (!askVersion()) {
        return fail("version again");
    }
    const QByteArray outputs = urRtdeControlOutputs(offset_);
    const QByteArray types = rtde_->setupOutputs(major > 3 ? 500 : 125, outputs);
    if (types.isEmpty() || types.contains("NOT_FOUND") || types.count(',') + 1 != outputs.count(',')) {
        return fail("output recipe");
    }
    int id = 0;
    for (const QByteArray& recipe : urRtdeControlRecipes(offset_)) {
        const auto reply = rtde_->request('I', recipe);
        if (reply.type != 'I' || reply.payload.contains("IN_USE") || reply.payload[0] != ++id) {
            return fail("input recipe");
        }
    }
    if (!rtde_->start()) {
        return fail("start");
    }
    step();
    clear();
    return upload();
}

// The upload sequence of the start-up and of `reuploadScript`.
bool RegisterClient::upload(const QByteArray& path) {
    if (state_.runtime == kPlaying) {
        if (!stopScript()) {
            return fail("the script does not end");
        }
        if (dashboard_->ask("stop") != "Stopped\n") {
            return fail("stop");
        }
        step(50);
    }
    script_->send(registerScript(offset_, path));
    robot_.controller.drainSockets();
    return until([this] { return state_.runtime == kPlaying; }, 5) || fail("script does not play");
}

void RegisterClient::step(int ticks) {
    for (int n = 0; n < ticks; ++n) {
        robot_.controller.step();
        RawRtde::Package package = rtde_->next();
        while (package.type != 'U' && package.type != 0) {
            package = rtde_->next();
        }
        const QByteArray& p = package.payload;
        if (p.size() != 1 + 6 * 4 + 6 * 8) {
            trouble = "no data";
            return;
        }
        state_.robotBits = wordAt(p, 1);
        state_.safetyBits = wordAt(p, 5);
        state_.runtime = wordAt(p, 9);
        for (int i = 0; i < 3; ++i) {
            state_.ints[static_cast<std::size_t>(i)] = intAt(p, 13 + 4 * i);
        }
        for (int i = 0; i < 6; ++i) {
            state_.doubles[static_cast<std::size_t>(i)] = doubleAt(p, 25 + 8 * i);
        }
    }
}

// Sends values in the order of the recipe. The first integer is the command, and the others follow in recipe
// order.
bool RegisterClient::send(Recipe recipe, int id, const std::vector<double>& doubles,
                          const std::vector<int>& ints) {
    QByteArray package(1, recipe);
    package += bigEndian(qint32(id));
    const auto addDoubles = [&] {
        for (const double d : doubles) {
            package += bigEndian(d);
        }
    };
    const bool doublesFirst = recipe == kMove || recipe == kStop;
    if (doublesFirst) {
        addDoubles();
    }
    for (const int i : ints) {
        package += bigEndian(qint32(i));
    }
    if (!doublesFirst) {
        addDoubles();
    }
    const std::uint64_t before = robot_.controller.inputPackages();
    rtde_->sendPackage('U', package);
    return robot_.controller.waitForInputPackages(before + 1, Deadline::after(std::chrono::seconds(20)));
}

bool RegisterClient::waitReady() {
    if (state_.runtime == kStopped) {
        clear();
        return fail("script stopped");
    }
    if (state_.runtime != kPlaying) {
        clear();
        return fail("not playing");
    }
    const bool ready =
        until([this] { return state_.ints[0] == 1 || inMode(kProtectiveStop) || inMode(kEmergencyStop); }, 3);
    return (ready && state_.ints[0] == 1) || fail("not ready");
}

bool RegisterClient::command(Recipe recipe, int id, std::initializer_list<double> doubles,
                             std::initializer_list<int> ints) {
    if (!waitReady() || !send(recipe, id, doubles, ints)) {
        return false;
    }
    const bool ended = until(
        [this] {
            return state_.ints[0] == 2 || state_.runtime != kPlaying || inMode(kProtectiveStop) ||
                   inMode(kEmergencyStop);
        },
        300);
    const bool done = ended && state_.ints[0] == 2 && state_.runtime == kPlaying &&
                      !inMode(kProtectiveStop) && !inMode(kEmergencyStop);
    clear();
    return done || fail("not done");
}

bool RegisterClient::stopScript() {
    send(kNothing, 255, {}, {});
    const bool ended = until([this] { return state_.runtime != kPlaying; }, 300);
    clear();
    return ended;
}

void RegisterClient::disconnect() {
    rtde_->close();
    script_->close();
    dashboard_->close();
}

}  // namespace tiller::test
