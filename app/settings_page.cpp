// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings_page.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QSignalBlocker>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "app/action_table.h"
#include "app/device_settings.h"
#include "app/interface_size.h"
#include "app/language.h"
#include "app/preference_table.h"
#include "app/recording_settings.h"
#include "widgets/common/choice_box.h"
#include "widgets/common/decimal_spin_box.h"
#include "widgets/common/density.h"
#include "widgets/common/no_focus_scroll_area.h"
#include "widgets/jog/device_jog.h"

namespace tiller::app {
namespace {

/// Row height that fits an editor [px].
int keyRowHeight() {
    return std::max(40, keyHeight(currentDensity()) + 4);
}

/// Makes the page scrollable, because with large rows its content exceeds the smallest screen.
QWidget* scrolling(QWidget* page, const QString& name) {
    auto* area = new NoFocusScrollArea;
    area->setAccessibleName(name);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setWidget(page);
    area->viewport()->setAutoFillBackground(false);
    page->setAutoFillBackground(false);
    return area;
}

QLabel* note(const QString& text, const char* role) {
    auto* label = new QLabel(text);
    label->setWordWrap(true);
    // Align with the field, because a row of the form may be taller than the text.
    label->setAlignment(Qt::AlignLeading | Qt::AlignTop);
    label->setProperty("role", QLatin1String(role));
    return label;
}

}  // namespace

SettingsPage::SettingsPage(const Preferences& preferences, const QString& theme, const ActionTable& actions,
                           DeviceJog& devices, QWidget* parent)
    : QDialog(parent), preferences_(preferences), actions_(actions) {
    setObjectName("settingsPage");
    setWindowTitle(tr("Settings"));
    resize(840, 640);
    pages_ = new QTabWidget;
    pages_->setObjectName("settingsPages");
    pages_->setAccessibleName(tr("Settings"));
    pages_->tabBar()->setAccessibleName(tr("Settings"));
    pages_->tabBar()->setDrawBase(false);
    pages_->addTab(scrolling(buildLook(theme), tr("Appearance and motion")), tr("Appearance and motion"));
    pages_->addTab(scrolling(buildDevices(devices), tr("Devices")), tr("Devices"));
    recording_ = scrolling(buildRecording(), tr("Recording"));
    pages_->addTab(recording_, tr("Recording"));
    pages_->addTab(buildShortcuts(), tr("Shortcuts"));
    auto* close = new QPushButton(tr("Close"));
    close->setObjectName("settingsClose");
    close->setAutoDefault(false);
    connect(close, &QPushButton::clicked, this, &QDialog::close);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(fileKey("settingsExport", tr("Export settings…"),
                               tr("Save all settings to one file, for another computer or as a backup"),
                               &SettingsPage::exportWanted));
    buttons->addWidget(fileKey("settingsImport", tr("Import settings…"),
                               tr("Show which settings a file will replace, then import them"),
                               &SettingsPage::importWanted));
    buttons->addStretch(1);
    buttons->addWidget(close);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 16, 24, 20);
    layout->setSpacing(12);
    layout->addWidget(pages_, 1);
    layout->addLayout(buttons);
}

QPushButton* SettingsPage::fileKey(const QString& name, const QString& text, const QString& tip,
                                   void (SettingsPage::*wanted)()) {
    auto* key = new QPushButton(text);
    key->setObjectName(name);
    key->setToolTip(tip);
    key->setAutoDefault(false);
    connect(key, &QPushButton::clicked, this, wanted);
    return key;
}

QComboBox* SettingsPage::choice(const QString& name, const QString& accessible, const QStringList& texts,
                                int current) {
    auto* box = new ChoiceBox;
    box->setObjectName(name);
    box->setAccessibleName(accessible);
    box->addItems(texts);
    box->setCurrentIndex(current);
    return box;
}

QWidget* SettingsPage::buildLook(const QString& theme) {
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setContentsMargins(0, 16, 0, 0);
    form->setVerticalSpacing(12);
    form->setHorizontalSpacing(20);
    for (const PreferenceRow& row : preferenceRows()) {
        if (row.editor != PreferenceRow::Editor::Custom) {
            addRow(*form, row);
        } else if (row.key == QLatin1String("look/language")) {
            languageNote_ = note({}, "secondary");
            languageNote_->setObjectName("settings.languageNote");
            form->addRow(tr("Language"), buildLanguage());
            form->addRow(QString(), languageNote_);
            addTheme(*form, theme);
        } else if (row.key == QLatin1String("look/size")) {
            addSize(*form);
        } else if (row.key == QLatin1String("motion/speedCap")) {
            addCap(*form);
        }
    }
    monitorOnly_ = page->findChild<QCheckBox*>("settings.monitorOnly");
    holdNote_ = note({}, "secondary");
    holdNote_->setObjectName("settings.holdNote");
    form->addRow(QString(), holdNote_);
    return page;
}

void SettingsPage::addRow(QFormLayout& form, const PreferenceRow& row) {
    form.addRow(tr(row.label), fieldOf(row));
    if (*row.note != '\0') {
        const QString text = row.noteNumber == 0 ? tr(row.note) : tr(row.note).arg(row.noteNumber);
        form.addRow(QString(), note(text, "secondary"));
    }
}

QWidget* SettingsPage::fieldOf(const PreferenceRow& row) {
    const QString name = "settings." + row.key.section(u'/', 1);
    const QVariant value = row.value(preferences_);
    if (row.editor == PreferenceRow::Editor::Choice) {
        QStringList titles;
        for (const char* title : row.titles) {
            titles << tr(title);
        }
        const auto chosen = std::find(row.words.begin(), row.words.end(), value.toString());
        auto* box = choice(name, tr(row.name), titles, static_cast<int>(chosen - row.words.begin()));
        connect(box, &QComboBox::activated, this, [this, &row](int index) {
            change(row, QString::fromLatin1(row.words.at(static_cast<std::size_t>(index))));
        });
        return box;
    }
    if (row.editor == PreferenceRow::Editor::Flag) {
        auto* box = new QCheckBox(tr(row.name));
        box->setObjectName(name);
        box->setChecked(value.toBool());
        connect(box, &QCheckBox::toggled, this, [this, &row](bool on) { change(row, on); });
        return box;
    }
    auto* box = new DecimalSpinBox;
    box->setObjectName(name);
    box->setAccessibleName(tr(row.name));
    box->setDecimals(0);
    box->setRange(row.min, row.max);
    box->setSingleStep(row.step);
    box->setSuffix(tr(row.unit));
    box->setValue(value.toInt());
    box->setToolTip(tr(row.toolTip));
    connect(box, &QDoubleSpinBox::valueChanged, this,
            [this, &row](double number) { change(row, static_cast<int>(number)); });
    return box;
}

void SettingsPage::change(const PreferenceRow& row, const QVariant& value) {
    row.setValue(preferences_, value);
    Q_EMIT preferencesChanged(preferences_);
    showCommandNames();  // some command names contain a length
}

void SettingsPage::addTheme(QFormLayout& form, const QString& theme) {
    theme_ = choice("settings.theme", tr("Colours"), {tr("Light"), tr("Dark")}, theme == "dark" ? 1 : 0);
    connect(theme_, &QComboBox::activated, this,
            [this](int index) { Q_EMIT themeChosen(index == 1 ? "dark" : "light"); });
    form.addRow(tr("Colours"), theme_);
}

void SettingsPage::addSize(QFormLayout& form) {
    QStringList sizes;
    for (const int size : kInterfaceSizes) {
        sizes << tr("%1 %").arg(size);
    }
    const auto chosen = std::find(kInterfaceSizes.begin(), kInterfaceSizes.end(), preferences_.interfaceSize);
    size_ = choice("settings.size", tr("Interface size"), sizes,
                   static_cast<int>(chosen - kInterfaceSizes.begin()));
    sizeNote_ = note({}, "secondary");
    sizeNote_->setObjectName("settings.sizeNote");
    showSizeNote();
    connect(size_, &QComboBox::activated, this, [this](int index) {
        preferences_.interfaceSize = kInterfaceSizes.at(static_cast<std::size_t>(index));
        showSizeNote();
        Q_EMIT preferencesChanged(preferences_);
    });
    form.addRow(tr("Interface size"), size_);
    form.addRow(QString(), sizeNote_);
}

void SettingsPage::addCap(QFormLayout& form) {
    cap_ = new DecimalSpinBox;
    cap_->setObjectName("settings.speedCap");
    cap_->setAccessibleName(tr("Tiller speed cap"));
    showCapValue();
    capNote_ = note({}, "secondary");
    capNote_->setObjectName("settings.speedCapNote");
    showCap();
    connect(cap_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        preferences_.speedCap = value * format::metresPerUnit();
        showCap();
        Q_EMIT preferencesChanged(preferences_);
    });
    form.addRow(tr("Speed cap"), cap_);
    form.addRow(QString(), capNote_);
}

QWidget* SettingsPage::buildLanguage() {
    // List the languages by their native names, so that users who cannot read the current language find
    // theirs.
    QStringList names{tr("System language: %1").arg(QString())};
    int current = 0;
    for (const Language& one : languages()) {
        if (one.code == languageFor({})) {
            names.front() = tr("System language: %1").arg(one.name);
        }
        names << one.name;
        current = one.code == preferences_.language ? static_cast<int>(names.size()) - 1 : current;
    }
    language_ = choice("settings.language", tr("Language"), names, current);
    reopen_ = new QPushButton(tr("Reopen window"));
    reopen_->setObjectName("settings.reopenWindow");
    reopen_->setAutoDefault(false);
    reopen_->setToolTip(
        tr("Stops the arm, gives control back and reconnects. The plots restart. The project is saved."));
    connect(language_, &QComboBox::activated, this, [this](int index) {
        preferences_.language = index == 0 ? QString() : languages()[index - 1].code;
        showLanguageNote();
        Q_EMIT preferencesChanged(preferences_);
    });
    connect(reopen_, &QPushButton::clicked, this, &SettingsPage::newWindowWanted);
    showLanguageNote();
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(language_, 1);
    layout->addWidget(reopen_);
    return row;
}

void SettingsPage::showLanguageNote() {
    const bool shown = languageFor(preferences_.language) == shownLanguage();
    reopen_->setEnabled(!shown);
    languageNote_->setText(
        shown
            ? tr("Language of the window and of the connection check. Files and scripts are not affected.")
            : tr("Takes effect when Tiller is restarted or the window is reopened. The plots then restart."));
}

void SettingsPage::refuseNewWindow(const QString& reason) {
    languageNote_->setText(reason);
}

void SettingsPage::showSizeNote() {
    const int chosen = preferences_.interfaceSize;
    const int fitting = fittingInterfaceSize(chosen, availableAtNormalSize(*screen()));
    sizeNote_->setText(
        chosen == interfaceSize() ? tr("Scales text, controls, plots and the view.")
        : fitting < chosen
            ? tr("Takes effect when Tiller is restarted, limited to %1 % on this screen.").arg(fitting)
            : tr("Takes effect when Tiller is restarted."));
}

void SettingsPage::showCapValue() {
    const double unit = format::metresPerUnit();
    const QSignalBlocker quiet(cap_);
    cap_->setDecimals(unit > 1e-3 ? 2 : 0);
    cap_->setRange(Preferences::kLowestCap / unit, Preferences::kHighestCap / unit);
    cap_->setSingleStep(unit > 1e-3 ? 0.5 : 10);
    cap_->setSuffix(QLatin1Char(' ') + format::speedUnit());
    cap_->setValue(preferences_.speedCap / unit);
}

void SettingsPage::changeEvent(QEvent* event) {
    if (event->type() == QEvent::StyleChange && shortcuts_ != nullptr) {
        showCapValue();  // units may have changed
        showCap();
        shortcuts_->verticalHeader()->setDefaultSectionSize(keyRowHeight());
    }
    QDialog::changeEvent(event);
}

void SettingsPage::showCap() {
    const bool raised = preferences_.speedCap > Preferences::kOrdinaryCap;
    capNote_->setProperty("role", raised ? QStringLiteral("warning") : QStringLiteral("secondary"));
    // Set the style sheet again, so that the changed property takes effect.
    capNote_->setStyleSheet(capNote_->styleSheet());
    capNote_->setText(
        raised ? tr("▲ Above %1. Manual mode and the enabling device of the teach pendant do not limit "
                    "jogging from a PC. The header shows a warning. The cap is reset when Tiller is closed.")
                     .arg(format::speed(Preferences::kOrdinaryCap))
               : tr("Maximum speed of the TCP and elbow for all motion commanded by Tiller. A change takes "
                    "effect immediately and stops any motion."));
}

QWidget* SettingsPage::buildDevices(DeviceJog& devices) {
    auto* page = new DeviceSettings(devices, preferences_.devices);
    connect(page, &DeviceSettings::tuningChosen, this,
            [this](const QString& kind, const DeviceTuning& tuning) {
                preferences_.devices[kind] = tuning;
                Q_EMIT preferencesChanged(preferences_);
            });
    connect(&devices, &DeviceJog::tuned, this,
            [this](const QString& kind, const DeviceTuning& tuning) { preferences_.devices[kind] = tuning; });
    connect(page, &DeviceSettings::trainerWanted, this, &SettingsPage::trainerWanted);
    return page;
}

QWidget* SettingsPage::buildRecording() {
    auto* page = new RecordingSettings(preferences_.recording);
    connect(page, &RecordingSettings::chosen, this, [this](const RecordingChoice& choice) {
        preferences_.recording = choice;
        Q_EMIT preferencesChanged(preferences_);
    });
    return page;
}

void SettingsPage::showRecording() {
    pages_->setCurrentWidget(recording_);
}

QWidget* SettingsPage::buildShortcuts() {
    auto* page = new QWidget;
    shortcuts_ = new QTableWidget(0, 2);
    shortcuts_->setObjectName("settings.shortcuts");
    shortcuts_->setAccessibleName(tr("Keyboard shortcuts"));
    shortcuts_->setHorizontalHeaderLabels({tr("Command"), tr("Shortcut")});
    shortcuts_->verticalHeader()->hide();
    shortcuts_->verticalHeader()->setDefaultSectionSize(keyRowHeight());
    shortcuts_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    shortcuts_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    shortcuts_->setColumnWidth(1, 300);
    shortcuts_->setShowGrid(false);
    shortcuts_->setSelectionMode(QAbstractItemView::NoSelection);
    shortcuts_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    shortcuts_->setTabKeyNavigation(false);
    hint_ = note({}, "warning");
    hint_->setObjectName("settings.shortcutHint");
    auto* defaults = new QPushButton(tr("Restore default shortcuts"));
    defaults->setObjectName("settings.shortcutDefaults");
    defaults->setAutoDefault(false);
    connect(defaults, &QPushButton::clicked, this, [this] {
        preferences_.shortcuts.clear();
        Q_EMIT preferencesChanged(preferences_);
        hint_->clear();
        showShortcuts();
    });
    auto* row = new QHBoxLayout;
    row->addWidget(hint_, 1);
    row->addWidget(defaults);
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 12, 0, 0);
    layout->addWidget(note(tr("Press the new shortcut in the field, or Backspace to remove the shortcut. "
                              "While Tiller is in control, Space and Esc always stop the arm."),
                           "secondary"));
    layout->addWidget(shortcuts_, 1);
    layout->addLayout(row);
    showShortcuts();
    return page;
}

void SettingsPage::showShortcuts() {
    shortcuts_->setRowCount(0);
    for (const QAction* action : actions_.all()) {
        const int row = shortcuts_->rowCount();
        shortcuts_->insertRow(row);
        auto* name = new QTableWidgetItem(plain(*action));
        name->setToolTip(ActionTable::helpOf(*action));
        shortcuts_->setItem(row, 0, name);
        auto* keys = new QKeySequenceEdit(action->shortcut());
        keys->setObjectName("settings.key." + action->objectName());
        keys->setAccessibleName(tr("Shortcut for %1").arg(plain(*action)));
        const QString id = action->objectName();
        connect(keys, &QKeySequenceEdit::editingFinished, this, [this, keys, id] {
            const QAction* edited = actions_.find(id);
            // Use only the first key combination. The editor also records further keys pressed within a
            // second.
            const QKeySequence chosen =
                keys->keySequence().isEmpty() ? QKeySequence() : QKeySequence(keys->keySequence()[0]);
            if (edited != nullptr && chosen != edited->shortcut()) {
                setShortcut(id, chosen);
            }
            keys->setKeySequence(edited == nullptr ? QKeySequence() : edited->shortcut());
        });
        shortcuts_->setCellWidget(row, 1, keys);
    }
}

void SettingsPage::showCommandNames() {
    const QList<QAction*>& all = actions_.all();
    for (int row = 0; row < shortcuts_->rowCount() && row < all.size(); ++row) {
        shortcuts_->item(row, 0)->setText(plain(*all[row]));
    }
}

bool SettingsPage::setShortcut(const QString& id, const QKeySequence& keys) {
    if (stopsTheArm(keys)) {
        hint_->setText(
            tr("%1 is reserved for stopping the arm.").arg(keys.toString(QKeySequence::NativeText)));
        return false;
    }
    const QAction* action = actions_.find(id);
    if (action == nullptr) {
        return false;
    }
    for (const QAction* other : actions_.all()) {
        if (other != action && !keys.isEmpty() && other->shortcut() == keys &&
            ActionTable::share(*action, *other)) {
            hint_->setText(tr("%1 is assigned to “%2”. Remove that shortcut first.")
                               .arg(keys.toString(QKeySequence::NativeText), plain(*other)));
            return false;
        }
    }
    if (keys == ActionTable::builtInShortcut(*action)) {
        preferences_.shortcuts.remove(id);
    } else {
        preferences_.shortcuts[id] = keys;
    }
    hint_->clear();
    Q_EMIT preferencesChanged(preferences_);
    return true;
}

void SettingsPage::lockMonitorOnly() {
    const QSignalBlocker quiet(monitorOnly_);
    monitorOnly_->setChecked(true);
    monitorOnly_->setEnabled(false);
    monitorOnly_->setText(tr("Monitor only (set on the command line)"));
}

void SettingsPage::setHoldNote(const QString& text) {
    holdNote_->setText(text);
}

QString SettingsPage::hint() const {
    return hint_->text();
}

}  // namespace tiller::app

#include "moc_settings_page.cpp"
