// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A band below the plots of a recording. Shows the progress of the comparison between arm and model, or the
// time of the first deviation.

#include <QFrame>

class QToolButton;

namespace tiller {

class ElidedLabel;

class ComparisonBand : public QFrame {
    Q_OBJECT

public:
    /// Function of the first button.
    enum class Key { None, Cancel, GoThere };

    explicit ComparisonBand(QWidget* parent = nullptr);

    /// parted  true if the plots mark a deviation; the band then shows the same flag
    void tell(const QString& words, const QString& details, Key key, bool parted);
    QString words() const;
    QString details() const { return details_; }

Q_SIGNALS:
    void cancelWanted();
    void momentWanted();
    /// The user wants to compare using different limits or a different model.
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
