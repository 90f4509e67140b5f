"""Reports of studies: the same sections as one HTML page, as Markdown and as CSV tables."""

from dataclasses import dataclass

from core_models.errors import UnsupportedError
from studies.output.output_folder import OutputFolder
from studies.report.parts import Picture, Plot, Table

AGREE, APART, NEUTRAL, TOLD = "agree", "apart", "", "told"


@dataclass(frozen=True)
class Verdict:
    """A sentence that says what came out.

    kind : AGREE, APART, NEUTRAL where it cannot be said, TOLD where nothing is judged; it gives the mark.
    """

    kind: str
    text: str


@dataclass(frozen=True)
class Section:
    """A heading with sentences, verdicts, tables and figures.

    name : of its CSV files and its place on the page. lead : what it is about. plots : curves. pictures : fields on
    bodies. figures : ready pieces of HTML, shown after both. controls : HTML above them. caption : below them. data :
    tables for the CSV files, with all digits and in SI units; without them those that are shown. at_a_glance : tables
    and figures stand side by side above the verdicts.
    """

    name: str
    title: str
    tables: tuple[Table, ...] = ()
    plots: tuple[Plot, ...] = ()
    remarks: tuple[str, ...] = ()
    lead: str = ""
    verdicts: tuple[Verdict, ...] = ()
    figures: tuple[str, ...] = ()
    controls: str = ""
    caption: str = ""
    data: tuple[Table, ...] = ()
    pictures: tuple[Picture, ...] = ()
    at_a_glance: bool = False

    @property
    def has_content(self) -> bool:
        """Whether there is anything below the heading."""
        return bool(
            self.remarks
            or self.verdicts
            or self.plots
            or self.pictures
            or self.figures
            or any(each.rows for each in self.tables)
        )

    def files(self) -> dict[str, Table]:
        """The tables that are kept as CSV, by the names of their files."""
        kept = [each for each in self.data or self.tables if each.rows]
        return {f"{self.name}{f'-{k + 1}' if k else ''}.csv": each for k, each in enumerate(kept)}


@dataclass(frozen=True)
class Report:
    """A study's report: title, one sentence of what it is, facts in a few words each, sections.

    warnings : what went wrong, told before everything else. footnotes : small print at the end.
    """

    title: str
    lead: str
    facts: tuple[str, ...]
    sections: tuple[Section, ...]
    warnings: tuple[str, ...] = ()
    footnotes: tuple[str, ...] = ()

    def _repr_html_(self) -> str:
        """As a notebook shows it."""
        from studies.report.document import fragment

        return fragment(self)


def write_report(report: Report, folder: OutputFolder) -> str:
    """Write report.html, report.md and a CSV file for each table; returns a sentence if the page could not be made."""
    from studies.report.document import page
    from studies.report.markdown import csv_text, markdown

    folder.write_text("report.md", markdown(report))
    for each in report.sections:
        for name, content in each.files().items():
            folder.write_text(name, csv_text(content))
    try:
        folder.write_text("report.html", page(report))
    except UnsupportedError as reason:
        return f"{reason}; report.md and the tables are complete"
    return ""
