// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording_settings.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "robot/station/text/format.h"
#include "widgets/common/choice_box.h"
#include "widgets/common/decimal_spin_box.h"
#include "widgets/common/empty_state.h"
#include "widgets/plots/metadata_dialog.h"

namespace tiller::app {

namespace {

constexpr int kMinListHeight = 140;  // [px]
constexpr double kPacketRate = 500;  // packet rate of an e-Series robot [Hz]; four times that of a CB3

QLabel* namedSecondary(const QString& name) {
    auto* label = new QLabel;
    label->setObjectName(name);
    label->setWordWrap(true);
    label->setProperty("role", QStringLiteral("secondary"));
    return label;
}

}  // namespace

RecordingSettings::RecordingSettings(const RecordingChoice& choice, QWidget* parent)
    : QWidget(parent)
    , choice_(choice.sane())
    , folder_(new QLineEdit)
    , pattern_(new QLineEdit)
    , example_(namedSecondary(QStringLiteral("settings.recording.example")))
    , every_(new DecimalSpinBox)
    , rate_(namedSecondary(QStringLiteral("settings.recording.rate")))
    , format_(new ChoiceBox)
    , keepFree_(new DecimalSpinBox)
    , fileMinutes_(box("fileMinutes", tr("Maximum duration of a file, in minutes"),
                       RecordingChoice::kMaxFileMinutes, choice_.fileMinutes))
    , fileSize_(box("fileSize", tr("Maximum size of a file, in megabytes"), RecordingChoice::kMaxFileSize,
                    choice_.fileSize))
    , metadata_(new QPushButton)
    , asksMetadata_(new ChoiceBox)
    , trigger_(new QLineEdit)
    , triggerNote_(namedSecondary(QStringLiteral("settings.recording.triggerNote")))
    , before_(box("before", tr("Recorded time before the trigger, in seconds"), RecordingChoice::kMaxBefore,
                  choice_.before))
    , after_(box("after", tr("Recorded time after the trigger, in seconds"), RecordingChoice::kMaxAfter,
                 choice_.after))
    , search_(new QLineEdit)
    , signals_(new QListWidget)
    , nothing_(nullptr) {
    build();
    showExample();
    connect(folder_, &QLineEdit::editingFinished, this, &RecordingSettings::takeFolder);
    connect(pattern_, &QLineEdit::textEdited, this, [this] { showExample(); });
    connect(pattern_, &QLineEdit::editingFinished, this, &RecordingSettings::takePattern);
    connect(every_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        RecordingChoice next = choice_;
        next.every = static_cast<int>(value);
        tell(next);
        showExample();
    });
    connect(format_, &QComboBox::currentIndexChanged, this, [this] {
        RecordingChoice next = choice_;
        next.format = format_->currentData().toString();
        tell(next);
        showExample();
    });
    connect(keepFree_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        RecordingChoice next = choice_;
        next.keepFree = static_cast<int>(value);
        tell(next);
    });
    for (const DecimalSpinBox* each : {fileMinutes_, fileSize_, before_, after_}) {
        connect(each, &QDoubleSpinBox::valueChanged, this, &RecordingSettings::followLimits);
    }
    connect(metadata_, &QPushButton::clicked, this, &RecordingSettings::editMetadata);
    connect(asksMetadata_, &QComboBox::currentIndexChanged, this, [this](int index) {
        RecordingChoice next = choice_;
        next.asksMetadata = index == 1;
        tell(next);
    });
    connect(trigger_, &QLineEdit::textEdited, this, &RecordingSettings::showTrigger);
    connect(trigger_, &QLineEdit::editingFinished, this, &RecordingSettings::takeTrigger);
    connect(search_, &QLineEdit::textChanged, this, &RecordingSettings::search);
    connect(signals_, &QListWidget::itemChanged, this, &RecordingSettings::takeSignals);
}

void RecordingSettings::build() {
    folder_->setObjectName(QStringLiteral("settings.recording.folder"));
    folder_->setAccessibleName(tr("Folder for recordings"));
    folder_->setPlaceholderText(QDir::toNativeSeparators(recordingFolder()));
    folder_->setText(QDir::toNativeSeparators(choice_.folder));
    auto* choose = new QPushButton(tr("Choose…"));
    choose->setObjectName(QStringLiteral("settings.recording.chooseFolder"));
    choose->setAccessibleName(tr("Choose the folder for recordings"));
    choose->setAutoDefault(false);
    connect(choose, &QPushButton::clicked, this, &RecordingSettings::askForFolder);
    auto* place = new QHBoxLayout;
    place->addWidget(folder_, 1);
    place->addWidget(choose);

    pattern_->setObjectName(QStringLiteral("settings.recording.pattern"));
    pattern_->setAccessibleName(tr("File name pattern"));
    pattern_->setText(choice_.pattern);
    pattern_->setToolTip(tr("{date}, {time}, {robot} and {number} are replaced when a recording starts."));

    every_->setObjectName(QStringLiteral("settings.recording.every"));
    every_->setAccessibleName(tr("Packets/row"));
    every_->setDecimals(0);
    every_->setRange(1, RecordingChoice::kMaxDecimation);
    every_->setValue(choice_.every);

    format_->setObjectName(QStringLiteral("settings.recording.format"));
    format_->setAccessibleName(tr("Recording format"));
    for (const recording::FileFormat* format : recording::formatsIn(recording::FormatSet::Recorded)) {
        format_->addItem(recordingFormatWords(*format).choice, format->suffixes.constFirst());
    }
    format_->setCurrentIndex(format_->findData(choice_.format));
    keepFree_->setObjectName(QStringLiteral("settings.recording.keepFree"));
    keepFree_->setAccessibleName(tr("Free disk space to keep, in megabytes"));
    keepFree_->setDecimals(0);
    keepFree_->setRange(0, RecordingChoice::kMaxKeptFree);
    keepFree_->setSuffix(tr(" MB"));
    keepFree_->setToolTip(
        tr("Recording stops, and the file is saved, before the free disk space falls below this value."));
    keepFree_->setValue(choice_.keepFree);

    for (DecimalSpinBox* each : {fileMinutes_, fileSize_}) {
        each->setDecimals(0);
        each->setSpecialValueText(tr("No limit"));
        each->setToolTip(tr("A longer recording continues in a new file without losing packets."));
    }
    fileMinutes_->setSuffix(tr(" min"));
    fileSize_->setSuffix(tr(" MB"));
    metadata_->setObjectName(QStringLiteral("settings.recording.metadata"));
    metadata_->setAccessibleName(tr("Metadata of recordings"));
    metadata_->setAutoDefault(false);
    asksMetadata_->setObjectName(QStringLiteral("settings.recording.asksMetadata"));
    asksMetadata_->setAccessibleName(tr("When to enter metadata"));
    asksMetadata_->addItems({tr("Use for each recording"), tr("Ask before each recording")});
    asksMetadata_->setCurrentIndex(choice_.asksMetadata ? 1 : 0);
    showMetadata();
    trigger_->setObjectName(QStringLiteral("settings.recording.trigger"));
    trigger_->setAccessibleName(tr("Trigger"));
    trigger_->setPlaceholderText(tr("None: recording starts at once"));
    trigger_->setClearButtonEnabled(true);
    trigger_->setText(choice_.trigger);
    trigger_->setToolTip(
        tr("Combine conditions with “and” and “or”, for example:\n"
           "norm(actual_TCP_force_0, actual_TCP_force_1) > 20 and robot_mode = 7\n"
           "actual_digital_input_bits:3 = 1\nruntime_state changes\nprogram starts"));
    for (DecimalSpinBox* each : {before_, after_}) {
        each->setDecimals(1);
        each->setSuffix(tr(" s"));
    }

    search_->setObjectName(QStringLiteral("settings.recording.search"));
    search_->setAccessibleName(tr("Search signals"));
    search_->setPlaceholderText(tr("Search signals"));
    search_->setClearButtonEnabled(true);
    signals_->setObjectName(QStringLiteral("settings.recording.signals"));
    signals_->setAccessibleName(tr("Signals in a recording"));
    const QStringList fields = recordableFields();
    for (const QString& field : fields) {
        auto* item = new QListWidgetItem(field, signals_);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        const bool recorded = choice_.fields.isEmpty() || choice_.fields.contains(field);
        item->setCheckState(recorded ? Qt::Checked : Qt::Unchecked);
    }
    nothing_ = new EmptyState(*signals_);
    auto* all = new QPushButton(tr("All signals"));
    all->setObjectName(QStringLiteral("settings.recording.all"));
    all->setAccessibleName(all->text());
    all->setAutoDefault(false);
    connect(all, &QPushButton::clicked, this, &RecordingSettings::chooseAll);
    auto* above = new QHBoxLayout;
    above->addWidget(search_, 1);
    above->addWidget(all);

    // In some languages, the longest entry is wider than the page.
    format_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    format_->setMinimumContentsLength(12);
    auto* form = new QFormLayout;
    form->setVerticalSpacing(12);
    form->setHorizontalSpacing(20);
    form->addRow(tr("Format"), format_);
    form->addRow(tr("Folder"), place);
    form->addRow(tr("File name"), pattern_);
    form->addRow(QString(), example_);
    form->addRow(tr("Packets/row"), every_);
    form->addRow(QString(), rate_);
    const auto pair = [](QWidget* first, const QString& between, QWidget* second) {
        auto* row = new QHBoxLayout;
        row->addWidget(first, 1);
        if (!between.isEmpty()) {
            row->addWidget(new QLabel(between));
        }
        row->addWidget(second, 1);
        return row;
    };
    form->addRow(tr("Keep free"), keepFree_);
    form->addRow(tr("New file after"), pair(fileMinutes_, {}, fileSize_));
    form->addRow(tr("Metadata"), pair(metadata_, {}, asksMetadata_));
    form->addRow(tr("Trigger"), trigger_);
    form->addRow(QString(), triggerNote_);
    form->addRow(tr("Before trigger"), pair(before_, tr("after"), after_));
    showTrigger();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 16, 0, 0);
    layout->addLayout(form);
    layout->addLayout(above);
    signals_->setMinimumHeight(kMinListHeight);
    layout->addWidget(signals_, 1);
}

DecimalSpinBox* RecordingSettings::box(const char* name, const QString& accessibleName, double most,
                                       double value) {
    auto* box = new DecimalSpinBox;
    box->setObjectName(QStringLiteral("settings.recording.") + QLatin1String(name));
    box->setAccessibleName(accessibleName);
    box->setRange(0, most);
    box->setValue(value);
    return box;
}

void RecordingSettings::followLimits() {
    RecordingChoice next = choice_;
    next.fileMinutes = static_cast<int>(fileMinutes_->value());
    next.fileSize = static_cast<int>(fileSize_->value());
    next.before = before_->value();
    next.after = after_->value();
    tell(next);
}

void RecordingSettings::editMetadata() {
    auto* dialog =
        new MetadataDialog(choice_.metadata, choice_.asksMetadata, MetadataDialog::Purpose::Edit, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        RecordingChoice next = choice_;
        next.metadata = dialog->fields();
        next.asksMetadata = dialog->asksBeforeRecording();
        tell(next);
        const QSignalBlocker quiet(asksMetadata_);
        asksMetadata_->setCurrentIndex(choice_.asksMetadata ? 1 : 0);
        showMetadata();
    });
    dialog->open();
}

void RecordingSettings::showMetadata() {
    const auto fields = static_cast<int>(choice_.facts().size());
    metadata_->setText(fields == 0 ? tr("Metadata…") : tr("Metadata (%n field(s))…", nullptr, fields));
}

void RecordingSettings::takeTrigger() {
    if (triggerProblem(trigger_->text()).isEmpty()) {  // otherwise, the previous value remains
        RecordingChoice next = choice_;
        next.trigger = trigger_->text();
        tell(next);
    }
}

void RecordingSettings::showTrigger() {
    const QString problem = triggerProblem(trigger_->text());
    const QString role = problem.isEmpty() ? QStringLiteral("secondary") : QStringLiteral("warning");
    if (triggerNote_->property("role") != role) {
        triggerNote_->setProperty("role", role);
        triggerNote_->setStyleSheet(triggerNote_->styleSheet());
    }
    const QString none =
        tr("With a trigger, Tiller records only while the condition is true, in numbered files.");
    triggerNote_->setText(problem.isEmpty() ? none : QStringLiteral("▲ ") + problem);
}

void RecordingSettings::tell(const RecordingChoice& choice) {
    const RecordingChoice next = choice.sane();
    if (next != choice_) {
        choice_ = next;
        Q_EMIT chosen(choice_);
    }
}

void RecordingSettings::askForFolder() {
    const QString start = choice_.folder.isEmpty() ? recordingFolder() : choice_.folder;
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder for recordings"), start);
    if (!folder.isEmpty()) {
        folder_->setText(QDir::toNativeSeparators(folder));
        takeFolder();
    }
}

void RecordingSettings::takeFolder() {
    RecordingChoice next = choice_;
    const QString typed = folder_->text().trimmed();
    // Resolve a relative path from the home folder, because the user does not know the working directory.
    next.folder =
        typed.isEmpty() ? QString() : QDir::home().absoluteFilePath(QDir::fromNativeSeparators(typed));
    folder_->setText(QDir::toNativeSeparators(next.folder));
    tell(next);
}

void RecordingSettings::takePattern() {
    if (!patternProblem(pattern_->text()).isEmpty()) {
        return;  // showExample() shows the error, and the previous value remains
    }
    RecordingChoice next = choice_;
    next.pattern = pattern_->text().trimmed();
    tell(next);
    showExample();
}

void RecordingSettings::showExample() {
    const QString problem = patternProblem(pattern_->text());
    RecordingChoice typed = choice_;
    typed.pattern = pattern_->text();
    const QString role = problem.isEmpty() ? QStringLiteral("secondary") : QStringLiteral("warning");
    if (example_->property("role") != role) {
        example_->setProperty("role", role);
        // Set the style sheet again, so that the changed property takes effect.
        example_->setStyleSheet(example_->styleSheet());
    }
    const QString file =
        QFileInfo(recordingPath(typed, tr("Lab UR5e"), QDateTime::currentDateTime())).fileName();
    example_->setText(problem.isEmpty() ? tr("Example: %1. {date}, {time}, {robot}, {number} are "
                                             "placeholders. Existing files are never overwritten.")
                                              .arg(file)
                                        : QStringLiteral("▲ ") + problem);
    rate_->setText(
        tr("%n packet(s) per row: %1 rows per second from a robot that sends 500 packets per second.",
           nullptr, choice_.every)
            .arg(format::number(kPacketRate / choice_.every, choice_.every > 50 ? 1 : 0)));
}

void RecordingSettings::takeSignals() {
    RecordingChoice next = choice_;
    next.fields.clear();
    for (int row = 0; row < signals_->count(); ++row) {
        if (signals_->item(row)->checkState() == Qt::Checked) {
            next.fields << signals_->item(row)->text();
        }
    }
    if (next.fields.isEmpty()) {
        // A recording must contain at least one signal, so restore the previous selection.
        const QSignalBlocker quiet(signals_);
        for (int row = 0; row < signals_->count(); ++row) {
            const bool recorded = choice_.fields.contains(signals_->item(row)->text());
            signals_->item(row)->setCheckState(recorded ? Qt::Checked : Qt::Unchecked);
        }
        signals_->viewport()->update();
        return;
    }
    tell(next);
}

void RecordingSettings::chooseAll() {
    {
        const QSignalBlocker quiet(signals_);
        for (int row = 0; row < signals_->count(); ++row) {
            signals_->item(row)->setCheckState(Qt::Checked);
        }
    }
    signals_->viewport()->update();
    takeSignals();
}

void RecordingSettings::search(const QString& words) {
    const QStringList wanted = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    bool any = false;
    for (int row = 0; row < signals_->count(); ++row) {
        const QString field = signals_->item(row)->text();
        const bool matches = std::all_of(wanted.begin(), wanted.end(), [&field](const QString& word) {
            return field.contains(word, Qt::CaseInsensitive);
        });
        signals_->item(row)->setHidden(!matches);
        any = any || matches;
    }
    nothing_->tell(!any, words);
}

}  // namespace tiller::app

#include "moc_recording_settings.cpp"
