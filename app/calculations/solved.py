"""Sections of an answer as they are solved, and what they say together."""

from dataclasses import dataclass, field

from app.model import Values, accuracy_values, warning
from core.errors import Accuracy, Notice


@dataclass(slots=True)
class Solved:
    """Sections of an answer, and what they say of their accuracy and limits."""

    values: Values = field(default_factory=dict)
    accuracies: list[Accuracy] = field(default_factory=list)
    notices: dict[str, Notice] = field(default_factory=dict)

    def take(self, accuracy: Accuracy, notices: tuple[Notice, ...] = ()) -> None:
        """Note what a section says; of notices alike the first."""
        self.accuracies.append(accuracy)
        for notice in notices:
            self.notices.setdefault(notice.code, notice)

    def answer(self, run_time_us: float) -> Values:
        """The answer: accuracy by the worst section, with the method of the first."""
        worst = Accuracy(
            self.accuracies[0].method,
            max(float(each.relative_error) for each in self.accuracies),
            sum(each.evaluations for each in self.accuracies),
        )
        values = self.values | {"accuracy": accuracy_values(worst, run_time_us)}
        if self.notices:
            values["warnings"] = [*map(warning, self.notices.values())]
        return values
