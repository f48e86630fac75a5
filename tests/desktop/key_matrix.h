// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Every key that moves the arm, with every modifier and lock key before, while and after it is held, on
// several layouts: what there is to try, a part of it in which every pair of them is met, and the trial.

#include <QList>
#include <QString>

#include "tests/desktop/desktop_cell.h"

namespace tiller::test {

/// What is pressed for one motion: key codes, or characters where the layout decides which key that is.
struct HeldKey {
    QString name;
    QList<int> codes;       ///< pressed in this order
    QString characters;     ///< pressed after them
    bool numLock = false;   ///< only with NumLock lit does it mean this
    QString preparation{};  ///< what has to be done before, so that there is a way to go
};

enum class Modifier { None, Shift, Control, Alt, AltGr, NumLock, CapsLock };
/// When the modifier is pressed and let go; a lock key is switched on and off again at the same moments.
enum class Order {
    Before,  ///< down before the keys, up while they are held
    Around,  ///< down before the keys, up after them
    During,  ///< down and up while they are held
    After,   ///< down while they are held, up after them
};

struct MatrixCell {
    int key = 0;  ///< index of heldKeys()
    Modifier modifier = Modifier::None;
    Order order = Order::Before;
    int layout = 0;  ///< index of layouts()

    bool operator==(const MatrixCell&) const = default;
};

const QList<HeldKey>& heldKeys();
const QStringList& layouts();
QString nameOf(Modifier modifier);
QString nameOf(Order order);
QString nameOf(const MatrixCell& cell);

/// All of it. With no modifier there is no order.
QList<MatrixCell> wholeMatrix();
/// Few of them, in which each two values of key, layout, modifier and order meet. Always the same.
QList<MatrixCell> everyPair();

struct CellOutcome {
    enum class Kind {
        Stood,       ///< moved while held, and stood in time
        Late,        ///< moved, and stood, but later than the contract says
        GoesOn,      ///< still moved long after the last key
        DidNotMove,  ///< and should have: nothing was to be stopped
        OtherKeys,   ///< did not move, and that is right: with this modifier the keys mean something else
        NoSuchKeys,  ///< the layout has no such keys within reach of one hand
        Broken,      ///< the workplace itself gave up
    };
    Kind kind = Kind::Broken;
    double seconds = 0;  ///< from the last key to standstill
    QString note;        ///< why
};
QString nameOf(CellOutcome::Kind kind);

/// Tries cells one after the other, on a workplace that is made anew when it has to be.
class MatrixTrial {
public:
    CellOutcome run(const MatrixCell& cell);
    /// Why there is no workplace.
    QString what() const { return what_; }

private:
    bool makeReady(int layout);
    bool prepare(const QString& preparation);
    /// The keys in the order they are pressed; empty where the layout does not have them.
    QList<Typed> strokes(const HeldKey& key);
    /// Presses them. Returns why nothing is to be expected of it; empty when the arm should move.
    QString put(const HeldKey& key, const QList<Typed>& strokes, bool shiftHeld);
    static CellOutcome judge(const Standstill& stop);

    std::unique_ptr<DesktopCell> cell_;
    int layout_ = -1;
    Vector6 waypoint_ = Vector6::Zero();  ///< the joints where it was taught
    QString what_;
};

}  // namespace tiller::test
