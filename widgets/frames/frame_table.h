// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The frames as rows; the name is edited in place (F2 or double click).

#include <QTableView>

namespace tiller {

class FrameModel;

class FrameTable : public QTableView {
    Q_OBJECT

public:
    explicit FrameTable(FrameModel& model, QWidget* parent = nullptr);

    void renameCurrent();

Q_SIGNALS:
    void currentRowChanged(int row);

protected:
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void shareWidth();

    FrameModel& model_;
};

}  // namespace tiller
