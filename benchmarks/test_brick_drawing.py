"""How fast the virtual brick draws: 30 FILLRECT of 60 x 40 pixels and UPDATE, as one direct command."""

from pytest_benchmark.fixture import BenchmarkFixture

from ev3proto.brick import Brick
from ev3proto.text.assembly import assemble


def test_thirty_filled_rectangles(benchmark: BenchmarkFixture) -> None:
    rectangles = [f"UI_DRAW(FILLRECT, {place % 2}, {4 * place}, {3 * place}, 60, 40)" for place in range(30)]
    (message,) = assemble("\n".join([*rectangles, "UI_DRAW(UPDATE)"]), reply=True)
    frame = message.build()
    brick = Brick()
    replies = benchmark(brick.receive, frame)
    assert len(replies) == 1
