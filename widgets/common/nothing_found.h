// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a list says that a search has emptied: an empty list could also mean that there is nothing.

#include <QLabel>

class QAbstractScrollArea;

namespace tiller {

class NothingFound : public QLabel {
    Q_OBJECT

public:
    /// list  over which it stands
    explicit NothingFound(QAbstractScrollArea& list);

    /// words  what was searched for; empty where other choices have emptied the list
    void tell(bool nothing, const QString& words);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QAbstractScrollArea& list_;
};

}  // namespace tiller
