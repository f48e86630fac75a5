// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Every key that moves the arm, combined with every modifier and lock key before, during and after the hold,
// on several layouts. Contains the complete matrix, a part of it that covers all pairs, and a class that runs
// the cells of the matrix.

#include <QList>
#include <QString>

#include "tests/desktop/desktop_cell.h"

namespace tiller::test {

/// The keys that are pressed for one motion: key codes, or characters whose keys depend on the layout.
struct HeldKey {
    QString name;
    QList<int> codes;       ///< key codes in the order in which they are pressed
    QString characters;     ///< characters pressed after the codes
    bool numLock = false;   ///< true if the key has this meaning only with NumLock on
    QString preparation{};  ///< preparation that is required to make a motion possible
};

enum class Modifier { None, Shift, Control, Alt, AltGr, NumLock, CapsLock };
/// The times at which the modifier is pressed and released. A lock key is toggled at the same times.
enum class Order {
    Before,  ///< pressed before the keys and released while they are held
    Around,  ///< pressed before the keys and released after them
    During,  ///< pressed and released while the keys are held
    After,   ///< pressed while the keys are held and released after them
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

/// The complete matrix. Cells without a modifier exist in one order only.
QList<MatrixCell> wholeMatrix();
/// A small part of the matrix that covers each pair of values of key, layout, modifier and order.
/// The result is always the same.
QList<MatrixCell> everyPair();

struct CellOutcome {
    enum class Kind {
        Stood,       ///< the arm moved while held, and stopped in time
        Late,        ///< the arm moved, but stopped later than the contract permits
        GoesOn,      ///< the arm was still moving long after the last key was released
        DidNotMove,  ///< the arm did not move although a motion was expected, so there was nothing to stop
        OtherKeys,   ///< no motion, as expected, because the keys have another meaning with this modifier
        NoSuchKeys,  ///< the layout has no such keys, or one hand cannot reach them
        Broken,      ///< the workplace failed
    };
    Kind kind = Kind::Broken;
    double seconds = 0;  ///< time from the release of the last key to standstill [s]
    QString note;        ///< details
};
QString nameOf(CellOutcome::Kind kind);

/// Runs cells one after the other in a workplace that is created again if necessary.
class KeyMatrixRun {
public:
    CellOutcome run(const MatrixCell& cell);
    /// The reason why there is no workplace.
    QString what() const { return what_; }

private:
    bool makeReady(int layout);
    bool prepare(const QString& preparation);
    /// Returns the keys in the order in which they are pressed; empty if the layout does not have them.
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
