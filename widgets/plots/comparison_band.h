// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The line under the plots of a recording that says whether its arm did what the model of it does: how far the comparison
// is, or when they parted.

#include <QFrame>

class QToolButton;

namespace tiller {

class ElidedLabel;

class ComparisonBand : public QFrame {
    Q_OBJECT

public:
    /// What its first key is for.
    enum class Key { None, Cancel, GoThere };

    explicit ComparisonBand(QWidget* parent = nullptr);

    /// parted  it is marked in the plots, by the same flag as here
    void tell(const QString& words, const QString& details, Key key, bool parted);
    QString words() const;
    QString details() const { return details_; }

Q_SIGNALS:
    void cancelWanted();
    void momentWanted();
    /// With other limits, or another model.
    void comparisonWanted();

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void style();

    ElidedLabel* words_;
    QToolButton* key_;
    QToolButton* compare_;
    QString details_;
    Key what_ = Key::None;
    bool parted_ = false;
    bool styling_ = false;
};

}  // namespace tiller
