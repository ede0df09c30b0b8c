"""Solved sections of an answer with their common accuracy and notices."""

from dataclasses import dataclass, field

from app.model import Values, accuracy_values, warning
from core.errors import Accuracy, Notice


@dataclass(slots=True)
class Solved:
    """Sections of an answer with their accuracy and notices."""

    values: Values = field(default_factory=dict)
    accuracies: list[Accuracy] = field(default_factory=list)
    notices: dict[str, Notice] = field(default_factory=dict)

    def take(self, accuracy: Accuracy, notices: tuple[Notice, ...] = ()) -> None:
        """Note accuracy and notices of a section; only the first of equal notices is kept."""
        self.accuracies.append(accuracy)
        for notice in notices:
            self.notices.setdefault(notice.code, notice)

    def answer(self, run_time_us: float) -> Values:
        """Answer with the accuracy of the worst section and the method of the first."""
        worst = Accuracy(
            self.accuracies[0].method,
            max(float(each.relative_error) for each in self.accuracies),
            sum(each.evaluations for each in self.accuracies),
        )
        values = self.values | {"accuracy": accuracy_values(worst, run_time_us)}
        if self.notices:
            values["warnings"] = [*map(warning, self.notices.values())]
        return values
