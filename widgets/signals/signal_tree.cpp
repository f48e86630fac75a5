// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/signals/signal_tree.h"

#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QSortFilterProxyModel>
#include <QStandardItemModel>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>
#include <vector>

#include "robot/station/history/signal_store.h"
#include "widgets/common/density.h"
#include "widgets/common/empty_state.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {

constexpr int kKeys = Qt::UserRole + 1;   // QStringList: keys of the signals
constexpr int kWords = Qt::UserRole + 2;  // text searched by the filter
constexpr int kGroup = Qt::UserRole + 3;  // bool: a group, which can only be expanded and collapsed
constexpr int kMinList = 24;              // minimum height of the list, so that the panel does not grow: one
                                          // row [px]

class Model : public QStandardItemModel {
public:
    using QStandardItemModel::QStandardItemModel;

    QStringList mimeTypes() const override { return {QLatin1String(SignalTree::kMime)}; }
    QMimeData* mimeData(const QModelIndexList& indexes) const override {
        QStringList keys;
        for (const QModelIndex& index : indexes) {
            keys += index.data(kKeys).toStringList();
        }
        keys.removeDuplicates();
        auto* data = new QMimeData;
        data->setData(QLatin1String(SignalTree::kMime), keys.join(QLatin1Char('\n')).toUtf8());
        // Exclude derived signals, because an expression may use only signals of the robot or of a file.
        keys.removeIf([](const QString& key) { return key.contains(QLatin1Char('=')); });
        std::transform(keys.begin(), keys.end(), keys.begin(), &DerivedSignal::written);
        data->setText(keys.join(QStringLiteral(", ")));
        return data;
    }
};

/// Accepts rows that contain every word of the filter, in any order.
class Filter : public QSortFilterProxyModel {
public:
    explicit Filter(QObject* parent) : QSortFilterProxyModel(parent) { setRecursiveFilteringEnabled(true); }

    void setWords(const QStringList& words) {
        words_ = words;
        invalidateFilter();
    }

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
        const QString text = sourceModel()->index(row, 0, parent).data(kWords).toString();
        if (text.isEmpty()) {
            return words_.isEmpty();
        }
        return std::all_of(words_.begin(), words_.end(),
                           [&text](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
    }

private:
    QStringList words_;
};

QStandardItem* makeItem(const QString& text) {
    auto* item = new QStandardItem(text);
    item->setEditable(false);
    item->setDropEnabled(false);
    return item;
}

}  // namespace

SignalTree::SignalTree(const SignalStore& store, QWidget* parent)
    : QWidget(parent)
    , store_(store)
    , search_(new QLineEdit)
    , view_(new QTreeView)
    , model_(new Model(this))
    , shown_(new Filter(this))
    , derivation_(new QLineEdit)
    , problem_(new QLabel) {
    setObjectName(QStringLiteral("signals"));
    search_->setObjectName(QStringLiteral("signals.search"));
    search_->setPlaceholderText(tr("Search signals"));
    search_->setAccessibleName(tr("Search signals"));
    search_->setClearButtonEnabled(true);
    view_->setObjectName(QStringLiteral("signals.tree"));
    view_->setAccessibleName(tr("Robot signals"));
    view_->setHeaderHidden(true);
    view_->setMinimumHeight(kMinList);
    view_->setUniformRowHeights(true);
    view_->setTextElideMode(Qt::ElideMiddle);  // names often differ at the end, e.g. register numbers
    view_->setDragEnabled(true);
    view_->setDragDropMode(QAbstractItemView::DragOnly);
    view_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    view_->setExpandsOnDoubleClick(false);
    view_->setIndentation(14);
    view_->setFont(textFont(13));
    shown_->setSourceModel(model_);
    view_->setModel(shown_);
    nothing_ = new EmptyState(*view_);
    nothing_->setObjectName(QStringLiteral("signals.nothingFound"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 0, 4, 8);
    layout->setSpacing(4);
    layout->addWidget(search_);
    layout->addWidget(view_, 1);
    derivation_->setObjectName(QStringLiteral("signals.derivation"));
    derivation_->setPlaceholderText(tr("New: |F| [N] = norm(…)"));
    derivation_->setAccessibleName(tr("Derived signal"));
    derivation_->setToolTip(tr(
        "Enter a name, an optional unit in brackets, and an expression that uses signals. Drag signals "
        "here to insert their names. Functions: norm(a, b, …), deriv(a, 0.02), mean(a, 0.5), median(a, 0.1), "
        "integral(a, 0.5), lowpass(a, 10), highpass(a, 1), + − * / ^ and standard functions. Press Return "
        "to create the signal."));
    problem_->setObjectName(QStringLiteral("signals.derivation.problem"));
    problem_->setFont(textFont(12));
    problem_->setProperty("role", "warning");
    problem_->setWordWrap(true);
    problem_->hide();
    layout->addWidget(derivation_);
    layout->addWidget(problem_);
    fill();
    connect(&store_, &SignalStore::signalAdded, this, &SignalTree::fill);
    connect(derivation_, &QLineEdit::returnPressed, this,
            [this] { Q_EMIT derivationEntered(derivation_->text()); });
    connect(derivation_, &QLineEdit::textEdited, problem_, &QWidget::hide);
    connect(search_, &QLineEdit::textChanged, this, &SignalTree::filter);
    connect(search_, &QLineEdit::returnPressed, this, [this] { view_->setFocus(Qt::TabFocusReason); });
    connect(view_, &QTreeView::activated, this, &SignalTree::take);
}

void SignalTree::fill() {
    model_->clear();
    QStandardItem* group = nullptr;
    QStandardItem* family = nullptr;
    const auto addWords = [](QStandardItem* item, const SignalInfo& info) {
        item->setData(
            QStringList{info.group, info.family, info.label, info.key, info.meaning, info.unit}.join(
                QLatin1Char(' ')),
            kWords);
    };
    // Add derived signals first.
    std::vector<int> order;
    for (const bool derived : {true, false}) {
        for (int i = 0; i < store_.count(); ++i) {
            if (!store_.info(i).key.isEmpty() && store_.isRobots(i) != derived) {
                order.push_back(i);
            }
        }
    }
    const auto familySize = [this](int from) {
        int size = 0;
        for (int i = from; i < store_.count() && store_.info(i).family == store_.info(from).family &&
                           store_.info(i).group == store_.info(from).group;
             ++i) {
            ++size;
        }
        return size;
    };
    for (const int i : order) {
        const SignalInfo& info = store_.info(i);
        if (group == nullptr || group->text() != info.group) {
            group = makeItem(info.group);
            group->setData(true, kGroup);
            group->setDragEnabled(false);
            model_->appendRow(group);
            family = nullptr;
        }
        const QString unit = info.unit.isEmpty() ? QString() : QStringLiteral(" [%1]").arg(info.unit);
        if (family == nullptr || family->data(Qt::UserRole).toString() != info.family) {
            const bool alone = familySize(i) == 1;
            family = makeItem(info.family + unit);
            family->setData(info.family, Qt::UserRole);
            if (alone) {
                addWords(family, info);
                family->setToolTip(QStringLiteral("%1 · %2").arg(info.key, info.meaning));
            }
            group->appendRow(family);
            family->setData(QStringList(), kKeys);
            family->setData(alone, kGroup + 1);
        }
        family->setData(family->data(kKeys).toStringList() << info.key, kKeys);
        if (!family->data(kGroup + 1).toBool()) {
            QStandardItem* item = makeItem(info.label);
            item->setData(QStringList(info.key), kKeys);
            item->setToolTip(QStringLiteral("%1 · %2").arg(info.key, info.meaning));
            addWords(item, info);
            family->appendRow(item);
        }
        if (absent_.contains(info.field)) {
            QStandardItem* item = family->hasChildren() ? family->child(family->rowCount() - 1) : family;
            item->setEnabled(false);
            item->setToolTip(tr("%1: not sent by this robot.").arg(info.key));
        }
    }
    view_->expand(shown_->index(0, 0));
    view_->expand(shown_->index(1, 0));
    filter(search_->text());
}

void SignalTree::setAbsent(const QSet<QString>& fields) {
    if (fields != absent_) {
        absent_ = fields;
        fill();
    }
}

void SignalTree::showDerivationResult(const QString& problem) {
    problem_->setText(problem);
    problem_->setVisible(!problem.isEmpty());
    if (problem.isEmpty()) {
        derivation_->clear();
    }
}

void SignalTree::focusFilter() {
    search_->setFocus(Qt::ShortcutFocusReason);
    search_->selectAll();
}

void SignalTree::filter(const QString& words) {
    const QStringList all = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    static_cast<Filter*>(shown_)->setWords(all);
    if (!all.isEmpty()) {
        view_->expandAll();
    }
    nothing_->tell(shown_->rowCount() == 0, words);
}

void SignalTree::take(const QModelIndex& index) {
    if (index.data(kGroup).toBool()) {
        view_->setExpanded(index, !view_->isExpanded(index));
        return;
    }
    QStringList keys;
    const QModelIndexList chosen = view_->selectionModel()->selectedIndexes();
    for (const QModelIndex& one : chosen.contains(index) ? chosen : QModelIndexList{index}) {
        keys += one.data(kKeys).toStringList();
    }
    keys.removeDuplicates();
    Q_EMIT this->chosen(keys);
}

QStringList SignalTree::keysIn(const QMimeData* data) {
    return QString::fromUtf8(data->data(QLatin1String(kMime))).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
}

}  // namespace tiller

#include "moc_signal_tree.cpp"
