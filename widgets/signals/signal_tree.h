// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tree of all signals available from the robot, with a filter. The user drags a signal or a group of signals
// onto a plot, or adds it by a double click or Return. An input line below the tree defines derived signals,
// which are computed from other signals.

#include <QSet>
#include <QStringList>
#include <QWidget>

class QLabel;
class QLineEdit;
class QMimeData;
class QModelIndex;
class QSortFilterProxyModel;
class QStandardItem;
class QStandardItemModel;
class QTreeView;

namespace tiller {

class EmptyState;
class SignalStore;

class SignalTree : public QWidget {
    Q_OBJECT

public:
    explicit SignalTree(const SignalStore& store, QWidget* parent = nullptr);

    /// Sets the signals that this robot does not send. They are disabled, and their tooltips show the reason.
    void setAbsent(const QSet<QString>& fields);
    void focusFilter();
    /// Shows the result of entering a derived signal: an error text, or empty if the signal was created.
    void showDerivationResult(const QString& problem);

    /// Returns the signal keys in the MIME data of a drag.
    static QStringList keysIn(const QMimeData* data);
    static constexpr const char* kMime = "application/x-tiller-signals";

Q_SIGNALS:
    /// The user activated signals by a double click or Return.
    void chosen(const QStringList& keys);
    /// The user entered a derived signal. For the syntax, see DerivedSignal.
    void derivationEntered(const QString& text);

private:
    void fill();
    void filter(const QString& words);
    void take(const QModelIndex& index);

    const SignalStore& store_;
    QLineEdit* search_;
    QTreeView* view_;
    QStandardItemModel* model_;
    QSortFilterProxyModel* shown_;
    EmptyState* nothing_;
    QLineEdit* derivation_;
    QLabel* problem_;
    QSet<QString> absent_;
};

}  // namespace tiller
