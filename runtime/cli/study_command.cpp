#include "cli/study_command.hpp"

#include "study/run_study.hpp"

namespace orbweaver {

namespace {

constexpr const char* kMeaning =
    "study how wrong a scene's methods of integration are against what they cost (accuracy), where they hold "
    "(stability), or the same of ways to ask its surface (queries), to bring limbs to targets (ik) or to write "
    "in its web (inscription)";

constexpr const char* kHelp = R"(
accuracy   runs every method over a ladder of steps or tolerances, against a reference that a second method
           confirms, after a twin displaced by 1e-10 m has shown how long errors mean something. Leaves
           accuracy.csv (method,step_s,tolerance,error_m,wall_s,steps,outcome), accuracy_statistics.csv,
           accuracy.json, accuracy.svg and index.html in DIR, and prints the cheapest way to each error. Usually
           1 s is simulated.
stability  runs every method in each cell of a map over two options of the scene, and calls it stable, degraded,
           diverged or refused, and says why. Leaves stability.csv (method,<axis>,<axis>,class), stability.json,
           stability.svg and index.html in DIR, the adviser's prediction drawn over each map. Usually 0.5 s is simulated.
queries    asks the scene's surface the same seeded questions by every way there is: rays at random, at vertices and
           at edges, the polygon under bodies that walk, and under bodies just beyond an edge; against every triangle
           in extended precision. Leaves queries.csv (questions,way,asked,missed,invented,error_m,median_error_m,
           cost_s), queries.json, queries.svg and index.html in DIR. --method names a way.

ik         has the limbs of a scene's creatures, or of a species by its name, reach for the same targets by every way
           there is, over tolerances and over steps: feet on their loops, and places anywhere within reach. Leaves ik.csv
           (targets,way,setting,asked,missed,invented,error,median_error,cost_s), ik.json, ik.svg and index.html in DIR.
           --method names a way.
inscription  writes in the scene's web by every mode: on rasters of several sizes, against time; and against what is
           lost of the web's nature. Where it is text of ASCII and tesseract is installed, has it read from the view's own
           pictures, at rest and in the scene's wind, among all capitals, small letters or digits, whatever of these
           the text has, and its own signs. What fails in reading keeps nothing else from being written. Leaves inscription.csv, trade.csv, readings.csv,
           inscription.json, inscription.svg, trade.svg and index.html in DIR. --method names a mode.

An axis is any option of the scene, PATH=LOW..HIGH:COUNT, such as web.step=10us..20ms:16 or web.drag=0..1e-6:11:lin,
or a list, PATH=A,B,..., such as web.prestress=force_density,over_extension; without --axis the step and the module's
own choice ([study] in its manifest) are taken. Exit codes are those of run.
)";

bool is_axis(const std::string& text) { return study::parse_axis(text).has_value(); }

bool is_span(const std::string& text) {
    const auto seconds = parse_seconds(text);
    return seconds && *seconds > 0;
}

}  // namespace

StudyCommand::StudyCommand(CLI::App& app) : command_(app.add_subcommand("study", kMeaning)) {
    command_->footer(kHelp);
    command_->add_option("KIND", kind_, "accuracy, stability, queries, ik or inscription")
        ->required()
        ->check(CLI::IsMember({"accuracy", "stability", "queries", "ik", "inscription"}));
    scene_.add_to(*command_, settings_.run);
    command_->add_option("--out", settings_.out, "folder for the results; it is made")
        ->required()
        ->check(checked([](const std::string& text) { return !text.empty(); }, "a folder; name one"));
    command_->add_option("--method", settings_.methods, "study this method; repeatable; all when absent")
        ->allow_extra_args(false);
    references_ =
        command_
            ->add_option(
                "--references", settings_.references,
                "two methods, FIRST,SECOND: of the reference, and of what confirms it; implicit ones for "
                "scenes too stiff for explicit steps")
            ->delimiter(',')
            ->expected(2);
    command_
        ->add_option("--axis", axes_,
                     "stability: an axis, PATH=LOW..HIGH:COUNT[:lin|:log] or PATH=A,B,...; at most two")
        ->allow_extra_args(false)
        ->check(checked(is_axis,
                        "an axis; expected PATH=LOW..HIGH:COUNT[:lin|:log] with LOW below HIGH, known units "
                        "and a COUNT of 2 to 200, such as web.step=1e-5..0.01:16, or PATH=A,B,... with 2 to "
                        "200 values"));
    repeats_ = command_
                   ->add_option("--repeats", settings_.repeats,
                                "all but stability: timed runs, the median of which counts")
                   ->check(CLI::Range(1, 99))
                   ->capture_default_str();
    command_->add_option("--time", time_, "most wall clock time for all of it; refinement stops there (5 min)")
        ->check(checked(is_span, "a time above 0; expected seconds or a text such as \"5 min\""));
    command_->add_option("--table", settings_.table,
                         "the table whose module is studied, when there are several");
    command_->add_option("--threads", settings_.run.request.threads, "threads to compute with")
        ->check(CLI::Range(1, 256));
    command_->add_flag("--quiet", settings_.run.quiet, "no progress");
}

void StudyCommand::complete() {
    if (!parsed()) return;
    const bool stability = kind_ == "stability";
    if (!stability && !axes_.empty()) throw CLI::ValidationError("--axis", "only stability has axes");
    if (stability && repeats_->count() > 0) throw CLI::ValidationError("--repeats", "a map is not timed");
    if (kind_ == "queries" && references_->count() > 0)
        throw CLI::ValidationError("--references", "queries are held against every triangle");
    if (kind_ == "ik" && references_->count() > 0)
        throw CLI::ValidationError("--references", "limbs are held against their own geometry");
    if (kind_ == "inscription" && references_->count() > 0)
        throw CLI::ValidationError("--references", "what is written is held against its target");
    if (axes_.size() > 2) throw CLI::ValidationError("--axis", "a map has two; leave one out");
    if (axes_.size() == 2 && study::parse_axis(axes_[0])->path == study::parse_axis(axes_[1])->path)
        throw CLI::ValidationError(
            "--axis", "'" + study::parse_axis(axes_[0])->path + "' is named twice; name two options");
    scene_.complete(settings_.run);
    settings_.full_duration = !scene_.duration.empty();
    if (const auto seconds = parse_seconds(time_)) settings_.time = *seconds;
}

int StudyCommand::run() const {
    if (kind_ == "accuracy") {
        study::run_accuracy(settings_);
        return 0;
    }
    if (kind_ == "queries") {
        study::run_queries(settings_);
        return 0;
    }
    if (kind_ == "ik") {
        study::run_reaches(settings_);
        return 0;
    }
    if (kind_ == "inscription") {
        study::run_writings(settings_);
        return 0;
    }
    std::vector<study::AxisText> axes;
    for (const std::string& axis : axes_) axes.push_back(*study::parse_axis(axis));
    study::run_stability(settings_, axes);
    return 0;
}

}  // namespace orbweaver
