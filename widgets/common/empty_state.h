// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A message over a list that is empty, e.g. because no entry matches the search text.

#include <QLabel>

class QAbstractScrollArea;

namespace tiller {

class EmptyState : public QLabel {
    Q_OBJECT

public:
    /// list  the list that the message covers
    explicit EmptyState(QAbstractScrollArea& list);

    /// nothing  true if the list is empty
    /// words    search text; empty if the list is empty for another reason
    void tell(bool nothing, const QString& words);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QAbstractScrollArea& list_;
};

}  // namespace tiller
