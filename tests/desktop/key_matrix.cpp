// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/desktop/key_matrix.h"

#include <Eigen/Geometry>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace tiller::test {
namespace {

constexpr double kContract = 0.25;       // [s] robot time
constexpr double kGetsGoing = 1.5;       // [s] an expected motion must begin within this time
constexpr double kStaysPut = 0.15;       // [s] duration without motion if none is expected
constexpr double kStandsAlready = 0.02;  // [s] shorter, because the previous cell has already waited
constexpr double kFarEnough = 0.35;  // [rad] distance for Back or levelling, sufficient for many short holds
constexpr double kNearlyThere = 0.12;  // [rad]
constexpr int kAttempts = 10;
constexpr int kLongWayMs = 20'000;  // longer than any preparation

constexpr int kModifierCodes[] = {0, kShift, kControl, kAlt, kAltGr, kNumLock, kCapsLock};

int codeOf(Modifier modifier) {
    return kModifierCodes[int(modifier)];
}

/// Angle between the tool axis and the nearest axis of the base frame [rad].
double tiltOf(const Vector6& pose) {
    const Eigen::Vector3d turn = pose.tail<3>();
    const double angle = turn.norm();
    const Eigen::Vector3d axis = angle > 0 ? Eigen::Vector3d(turn / angle) : Eigen::Vector3d(0, 0, 1);
    const Eigen::Vector3d z = Eigen::AngleAxisd(angle, axis) * Eigen::Vector3d(0, 0, 1);
    return std::acos(std::min(1.0, z.cwiseAbs().maxCoeff()));
}

bool isLock(Modifier modifier) {
    return modifier == Modifier::NumLock || modifier == Modifier::CapsLock;
}

void change(XHand& hand, Modifier modifier, bool down) {
    if (modifier == Modifier::None) {
        return;
    }
    if (isLock(modifier)) {
        hand.tap(codeOf(modifier));
    } else {
        hand.key(codeOf(modifier), down);
    }
}

/// Returns the permitted key symbols for this key; empty if any symbol is permitted.
QStringList symbolsOf(int code, bool numLock) {
    switch (code) {
        case kKeypad4:
            return {numLock ? "KP_4" : "KP_Left"};
        case kKeypad6:
            return {"KP_Right"};
        case kKeypad8:
            return {"KP_Up"};
        case kKeypad2:
            return {"KP_Down"};
        case kKeypad9:
            return {"KP_Prior"};
        case kKeypad3:
            return {"KP_Next"};
        case kLetterF:
            // If the layout has no Latin letters, the key is identified by its position.
            return {"f", "F", "Cyrillic_a", "Cyrillic_A"};
        case kLetterG:
            return {"g", "G", "Cyrillic_pe", "Cyrillic_PE"};
        default:
            return {};
    }
}

QStringList symbolsOf(QChar character) {
    return character == '+'   ? QStringList{"plus", "equal"}
           : character == '-' ? QStringList{"minus", "underscore"}
                              : QStringList{QString(character)};
}

QList<HeldKey> makeKeys() {
    QList<HeldKey> keys;
    const std::pair<const char*, int> directions[] = {{"left", kLeft},      {"right", kRight},
                                                      {"up", kUp},          {"down", kDown},
                                                      {"page up", kPageUp}, {"page down", kPageDown}};
    for (const auto& [name, code] : directions) {
        keys.append({QLatin1String(name), {code}, {}});
    }
    for (const auto& [name, code] : directions) {
        keys.append({QStringLiteral("Alt %1").arg(QLatin1String(name)), {kAlt, code}, {}});
    }
    for (int joint = 1; joint <= 6; ++joint) {
        keys.append({QStringLiteral("%1 +").arg(joint), {}, QStringLiteral("%1+").arg(joint)});
        keys.append({QStringLiteral("%1 -").arg(joint), {}, QStringLiteral("%1-").arg(joint)});
    }
    const std::pair<const char*, int> keypad[] = {
        {"keypad left", kKeypad4}, {"keypad right", kKeypad6},   {"keypad up", kKeypad8},
        {"keypad down", kKeypad2}, {"keypad page up", kKeypad9}, {"keypad page down", kKeypad3}};
    for (const auto& [name, code] : keypad) {
        keys.append({QLatin1String(name), {code}, {}});
    }
    // Press the sign first, because a layout may require Shift for the digit.
    keys.append({"keypad + 1", {kKeypadPlus}, "1"});
    keys.append({"keypad - 1", {kKeypadMinus}, "1"});
    keys.append({"keypad + 6", {kKeypadPlus}, "6"});
    keys.append({"keypad - 6", {kKeypadMinus}, "6"});
    keys.append({"keypad 4 +", {kKeypad4, kKeypadPlus}, {}, true});
    keys.append({"keypad 4 -", {kKeypad4, kKeypadMinus}, {}, true});
    keys.append({"Home", {kHome}, {}});
    keys.append({"Backspace", {kBackspace}, {}, false, "back"});
    keys.append({"End", {kEnd}, {}, false, "tilt"});
    keys.append({"F", {kLetterF}, {}, false, "hand"});
    keys.append({"G", {kLetterG}, {}, false, "waypoint"});
    return keys;
}

}  // namespace

const QList<HeldKey>& heldKeys() {
    static const QList<HeldKey> keys = makeKeys();
    return keys;
}

const QStringList& layouts() {
    static const QStringList names{"us", "de", "fr", "es", "jp", "ru"};
    return names;
}

QString nameOf(Modifier modifier) {
    static const QStringList names{"none", "Shift", "Ctrl", "Alt", "AltGr", "NumLock", "CapsLock"};
    return names[int(modifier)];
}

QString nameOf(Order order) {
    static const QStringList names{"before", "around", "during", "after"};
    return names[int(order)];
}

QString nameOf(const MatrixCell& cell) {
    return QStringLiteral("%1 | %2 | %3 %4")
        .arg(layouts()[cell.layout], heldKeys()[cell.key].name, nameOf(cell.modifier),
             cell.modifier == Modifier::None ? QString() : nameOf(cell.order))
        .trimmed();
}

QString nameOf(CellOutcome::Kind kind) {
    static const QStringList names{"stood",      "LATE",         "GOES ON", "DID NOT MOVE",
                                   "other keys", "no such keys", "BROKEN"};
    return names[int(kind)];
}

QList<MatrixCell> wholeMatrix() {
    QList<MatrixCell> cells;
    for (int layout = 0; layout < layouts().size(); ++layout) {
        for (int key = 0; key < heldKeys().size(); ++key) {
            cells.append({key, Modifier::None, Order::Before, layout});
            for (int modifier = int(Modifier::Shift); modifier <= int(Modifier::CapsLock); ++modifier) {
                for (const Order order : {Order::Before, Order::Around, Order::During, Order::After}) {
                    cells.append({key, Modifier(modifier), order, layout});
                }
            }
        }
    }
    return cells;
}

QList<MatrixCell> everyPair() {
    // Each value of key, modifier, order and layout has a number.
    const int keys = int(heldKeys().size());
    constexpr int kModifiers = 7;
    constexpr int kOrders = 4;
    const int values = keys + kModifiers + kOrders + int(layouts().size());
    const auto pairsOf = [&](const MatrixCell& cell) {
        const bool ordered = cell.modifier != Modifier::None;  // without a modifier there is no order
        const int modifier = keys + int(cell.modifier);
        const int order = keys + kModifiers + int(cell.order);
        const int layout = keys + kModifiers + kOrders + cell.layout;
        const auto pair = [values](int one, int other) { return std::size_t(one * values + other); };
        std::vector<std::size_t> pairs{pair(cell.key, modifier), pair(cell.key, layout),
                                       pair(modifier, layout)};
        if (ordered) {
            pairs.insert(pairs.end(), {pair(cell.key, order), pair(modifier, order), pair(order, layout)});
        }
        return pairs;
    };
    struct Candidate {
        MatrixCell cell;
        std::vector<std::size_t> pairs;
    };
    std::vector<Candidate> candidates;
    std::vector<bool> open(std::size_t(values * values), false);
    for (const MatrixCell& cell : wholeMatrix()) {
        candidates.push_back({cell, pairsOf(cell)});
        for (const std::size_t pair : candidates.back().pairs) {
            open[pair] = true;
        }
    }
    QList<MatrixCell> chosen;
    while (std::ranges::find(open, true) != open.end()) {
        // Greedy selection: always choose the cell that covers the most open pairs.
        const Candidate& best = *std::ranges::max_element(candidates, {}, [&](const Candidate& candidate) {
            return std::ranges::count_if(candidate.pairs, [&](std::size_t pair) { return bool(open[pair]); });
        });
        for (const std::size_t pair : best.pairs) {
            open[pair] = false;
        }
        chosen.append(best.cell);
    }
    // Sort so that each layout is set only once, and cells with the same preparation are adjacent.
    std::ranges::stable_sort(chosen, {}, [](const MatrixCell& c) { return std::pair(c.layout, c.key); });
    return chosen;
}

// ---- KeyMatrixRun

bool KeyMatrixRun::makeReady(int layout) {
    if (!cell_) {
        cell_ = std::make_unique<DesktopCell>();
        layout_ = -1;
        if (!cell_->bringUp()) {
            what_ = cell_->what();
            cell_.reset();
            return false;
        }
        // Teach a waypoint for "Go to".
        cell_->hand().tap(kLetterT);
        if (!cell_->until([&] { return cell_->place("waypoint.goTo").enabled; })) {
            what_ = "no waypoint could be taught";
            return false;
        }
        waypoint_ = cell_->arm().joints();
    }
    if (layout_ != layout) {
        if (!cell_->setLayout(layouts()[layout])) {
            what_ = "the layout could not be set";
            return false;
        }
        layout_ = layout;
    }
    if (!cell_->armKeyboard()) {
        what_ = "keyboard jogging could not be armed";
        cell_.reset();
        return false;
    }
    return true;
}

bool KeyMatrixRun::prepare(const QString& preparation) {
    XHand& hand = cell_->hand();
    ArmWatch& arm = cell_->arm();
    // A busy computer may end a motion early. The motion is then started again.
    const auto turn = [&](int code, const std::function<bool()>& enough) {
        for (int attempt = 0; attempt < kAttempts && !enough(); ++attempt) {
            hand.press(kAlt);
            hand.press(code);
            arm.untilMoving(kGetsGoing);
            cell_->until([&] { return enough() || !arm.moves(); }, kLongWayMs);
            hand.release(code);
            hand.release(kAlt);
            arm.untilStanding(2);
        }
        return enough();
    };
    if (preparation == "tilt") {
        return tiltOf(arm.tcpPose()) > kNearlyThere ||
               turn(kRight, [&] { return tiltOf(arm.tcpPose()) > kFarEnough; });
    }
    if (preparation == "waypoint") {
        const auto way = [&] { return (arm.joints() - waypoint_).cwiseAbs().maxCoeff(); };
        return way() > kNearlyThere || turn(kPageUp, [&] { return way() > kFarEnough; });
    }
    if (preparation == "back") {
        const Vector6 from = arm.joints();
        return turn(kPageDown, [&] { return (arm.joints() - from).cwiseAbs().maxCoeff() > kNearlyThere; });
    }
    return true;
}

QList<Typed> KeyMatrixRun::strokes(const HeldKey& key) {
    QList<Typed> strokes;
    for (const int code : key.codes) {
        strokes.append({code, false});
    }
    for (const QChar character : key.characters) {
        // If "+" and "=" are on the same key, "+" without Shift is "=", and the application treats them as
        // the same key.
        const char wanted = character.toLatin1();
        std::optional<Typed> typed = cell_->hand().find(wanted);
        if (wanted == '+' && typed && typed->shift) {
            const std::optional<Typed> equal = cell_->hand().find('=');
            if (equal && equal->code == typed->code) {
                typed = equal;
            }
        }
        if (!typed || std::ranges::any_of(strokes, [&](const Typed& s) { return s.code == typed->code; })) {
            return {};
        }
        strokes.append(*typed);
    }
    return strokes;
}

QString KeyMatrixRun::put(const HeldKey& key, const QList<Typed>& strokes, bool shiftHeld) {
    XHand& hand = cell_->hand();
    QString other;
    bool shift = false;
    for (qsizetype i = 0; i < strokes.size(); ++i) {
        // A character that requires Shift is held together with Shift, because releasing a modifier would end
        // the motion.
        if (strokes[i].shift != shift && !shiftHeld) {
            shift = strokes[i].shift;
            hand.key(kShift, shift);
        }
        const QStringList meant = i < key.codes.size() ? symbolsOf(key.codes[i], key.numLock)
                                                       : symbolsOf(key.characters[i - key.codes.size()]);
        const QString written = hand.writes(strokes[i].code);
        if (!meant.isEmpty() && !meant.contains(written)) {
            other = QStringLiteral("one of the keys writes %1").arg(written);
        }
        hand.press(strokes[i].code);
    }
    return other;
}

CellOutcome KeyMatrixRun::judge(const Standstill& stop) {
    CellOutcome outcome;
    outcome.seconds = stop.seconds;
    outcome.kind = stop.verdict == Standstill::Verdict::Stood   ? CellOutcome::Kind::Stood
                   : stop.verdict == Standstill::Verdict::Late  ? CellOutcome::Kind::Late
                   : stop.verdict == Standstill::Verdict::Blind ? CellOutcome::Kind::Broken
                                                                : CellOutcome::Kind::GoesOn;
    return outcome;
}

CellOutcome KeyMatrixRun::run(const MatrixCell& cell) {
    if (!makeReady(cell.layout)) {
        return {CellOutcome::Kind::Broken, 0, what_};
    }
    const HeldKey& key = heldKeys()[cell.key];
    XHand& hand = cell_->hand();
    ArmWatch& arm = cell_->arm();
    const QList<Typed> keys = strokes(key);
    if (keys.isEmpty()) {
        return {CellOutcome::Kind::NoSuchKeys, 0, {}};
    }
    if (!prepare(key.preparation) || !arm.untilStanding(2, kStandsAlready)) {
        cell_.reset();
        return {CellOutcome::Kind::Broken, 0, "the arm could not be prepared"};
    }

    if (key.numLock) {
        hand.tap(kNumLock);
    }
    const bool early = cell.order == Order::Before || cell.order == Order::Around;
    if (early) {
        change(hand, cell.modifier, true);
    }
    QString other = put(key, keys, early && cell.modifier == Modifier::Shift);
    if (key.name == "G" && early && hand.hasModifier()) {
        other = "Go to is G without modifiers";
    }
    if (key.preparation == "hand") {
        cell_->fault("hand 20 0 0");  // external force; applied earlier, it would cause a payload warning
    }
    const bool moved = arm.untilMoving(other.isEmpty() ? kGetsGoing : kStaysPut);
    if (cell.order == Order::Before) {
        change(hand, cell.modifier, false);
    } else if (cell.order == Order::During) {
        change(hand, cell.modifier, true);
        change(hand, cell.modifier, false);
    } else if (cell.order == Order::After) {
        change(hand, cell.modifier, true);
    }
    for (const Typed& stroke : keys) {
        hand.release(stroke.code);
    }
    if (keys.last().shift && cell.modifier != Modifier::Shift) {
        hand.release(kShift);
    }
    CellOutcome outcome = judge(cell_->standstill(kContract));
    if (cell.order == Order::Around || cell.order == Order::After) {
        change(hand, cell.modifier, false);
    }

    const bool runsAway = outcome.kind == CellOutcome::Kind::GoesOn;
    if (!moved && outcome.kind == CellOutcome::Kind::Stood) {
        outcome.kind = other.isEmpty() ? CellOutcome::Kind::DidNotMove : CellOutcome::Kind::OtherKeys;
        outcome.note = other.isEmpty() ? cell_->surroundingsText() : other;
    }
    hand.letGoOfAll();
    if (key.preparation == "hand") {
        cell_->fault("hand 0 0 0");
    }
    if (runsAway) {
        // The next cell must not start with keys that still count as held.
        hand.tap(kEscape);
        outcome.note = arm.untilStanding(2) ? "Esc ended it" : "Esc did not end it";
        cell_.reset();
    }
    return outcome;
}

}  // namespace tiller::test
