// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Every key that moves the arm, combined with every modifier and lock key before, during and after the hold,
// on several layouts: the complete matrix, a part of it that covers all pairs, and a class that runs its
// cells.

#include <QList>
#include <QString>

#include "tests/desktop/desktop_cell.h"

namespace tiller::test {

/// Keys to be pressed for one motion: key codes, or characters whose keys depend on the layout.
struct HeldKey {
    QString name;
    QList<int> codes;       ///< pressed in this order
    QString characters;     ///< pressed after the codes
    bool numLock = false;   ///< has this meaning only with NumLock on
    QString preparation{};  ///< required preparation, so that a motion is possible
};

enum class Modifier { None, Shift, Control, Alt, AltGr, NumLock, CapsLock };
/// When the modifier is pressed and released. A lock key is toggled at the same times.
enum class Order {
    Before,  ///< pressed before the keys, released while they are held
    Around,  ///< pressed before the keys, released after them
    During,  ///< pressed and released while the keys are held
    After,   ///< pressed while the keys are held, released after them
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

/// The complete matrix. Without a modifier there is no order.
QList<MatrixCell> wholeMatrix();
/// A small part of the matrix that covers each pair of values of key, layout, modifier and order.
/// Deterministic.
QList<MatrixCell> everyPair();

struct CellOutcome {
    enum class Kind {
        Stood,       ///< moved while held, and stopped in time
        Late,        ///< moved, and stopped later than permitted by the contract
        GoesOn,      ///< still moved long after the last key was released
        DidNotMove,  ///< no motion although one was expected, so there was nothing to stop
        OtherKeys,   ///< no motion, as expected: with this modifier the keys have another meaning
        NoSuchKeys,  ///< the layout has no such keys within reach of one hand
        Broken,      ///< the workplace failed
    };
    Kind kind = Kind::Broken;
    double seconds = 0;  ///< from the release of the last key to standstill
    QString note;        ///< details
};
QString nameOf(CellOutcome::Kind kind);

/// Runs cells one after the other, on a workplace that is created again if necessary.
class MatrixTrial {
public:
    CellOutcome run(const MatrixCell& cell);
    /// The reason why there is no workplace.
    QString what() const { return what_; }

private:
    bool makeReady(int layout);
    bool prepare(const QString& preparation);
    /// The keys in the order of pressing; empty if the layout does not have them.
    QList<Typed> strokes(const HeldKey& key);
    /// Presses the keys. Returns the reason why no motion is expected; empty if the arm should move.
    QString put(const HeldKey& key, const QList<Typed>& strokes, bool shiftHeld);
    static CellOutcome judge(const Standstill& stop);

    std::unique_ptr<DesktopCell> cell_;
    int layout_ = -1;
    Vector6 waypoint_ = Vector6::Zero();  ///< joint positions of the taught waypoint [rad]
    QString what_;
};

}  // namespace tiller::test
