// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tools/part_model.h"

#include "widgets/common/theme.h"

namespace tiller {

PartModel::PartModel(Content content, QObject* parent)
    : QAbstractTableModel(parent), content_(std::move(content)), rows_(content_.count()) {}

void PartModel::follow() {
    const int now = content_.count();
    // Insert or remove rows only at the end, so that the remaining rows keep their selection. Then update all
    // values.
    if (now > rows_) {
        beginInsertRows({}, rows_, now - 1);
        rows_ = now;
        endInsertRows();
    } else if (now < rows_) {
        beginRemoveRows({}, now, rows_ - 1);
        rows_ = now;
        endRemoveRows();
    }
    if (rows_ > 0) {
        Q_EMIT dataChanged(index(0, 0), index(rows_ - 1, columnCount() - 1));
    }
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
}

int PartModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : rows_;
}

int PartModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : FirstValue + static_cast<int>(content_.valueHeadings().size());
}

QVariant PartModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rows_ || index.row() >= content_.count()) {
        return {};
    }
    const auto text = [&]() -> QString {
        switch (index.column()) {
            case Mark:
                return content_.isInUse(index.row()) ? QStringLiteral("●") : QString();
            case Name:
                return content_.name(index.row());
            default:
                return content_.figures(index.row()).value(index.column() - FirstValue);
        }
    };
    switch (role) {
        case Qt::DisplayRole:
        case Qt::EditRole:
            return text();
        case Qt::ToolTipRole:
            return index.column() == Mark && content_.isInUse(index.row()) ? content_.inUse : text();
        case Qt::AccessibleTextRole:
            return index.column() == Mark
                       ? (content_.isInUse(index.row()) ? content_.inUse : QString())
                       : QStringLiteral("%1 %2").arg(
                             headerData(index.column(), Qt::Horizontal, Qt::DisplayRole).toString(), text());
        case Qt::FontRole:
            return index.column() < FirstValue ? textFont(15) : numberFont(13);
        default:
            return {};
    }
}

bool PartModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !index.isValid() || index.column() != Name || index.row() >= rows_) {
        return false;
    }
    const QString name = value.toString().trimmed();
    if (name == content_.name(index.row())) {
        return true;
    }
    if (const QString problem = content_.nameProblem(index.row(), name); !problem.isEmpty()) {
        Q_EMIT editRefused(problem);
        return false;
    }
    content_.rename(index.row(), name);
    return true;
}

QVariant PartModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::TextAlignmentRole) {
        return QVariant(Qt::AlignLeft | Qt::AlignVCenter);
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    return section == Mark   ? QString()
           : section == Name ? tr("Name")
                             : content_.valueHeadings().value(section - FirstValue);
}

Qt::ItemFlags PartModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    return !index.isValid() ? Qt::NoItemFlags : index.column() == Name ? flags | Qt::ItemIsEditable : flags;
}

}  // namespace tiller

#include "moc_part_model.cpp"
