// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Everything the robot may tell as a tree with a filter. A signal, or a family of them, is dragged onto a plot, or
// taken by a double click or Return. Below it a line takes signals computed from others.

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

class NothingFound;
class SignalStore;

class SignalTree : public QWidget {
    Q_OBJECT

public:
    explicit SignalTree(const SignalStore& store, QWidget* parent = nullptr);

    /// Those that this robot does not send: they cannot be chosen, and say why.
    void setAbsent(const QSet<QString>& fields);
    void focusFilter();
    /// What became of the text that was entered: empty when it is a signal now.
    void tellDerivation(const QString& problem);

    /// What a drag carries.
    static QStringList keysIn(const QMimeData* data);
    static constexpr const char* kMime = "application/x-tiller-signals";

Q_SIGNALS:
    /// Chosen by a double click or Return.
    void chosen(const QStringList& keys);
    /// A signal to be computed from others, as DerivedSignal describes the text.
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
    NothingFound* nothing_;
    QLineEdit* derivation_;
    QLabel* problem_;
    QSet<QString> absent_;
};

}  // namespace tiller
