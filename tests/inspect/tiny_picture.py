"""The tiny recording's picture: the floor, and which of its pixels see the ball or lie in its shadow."""
import ball_of_glass as ball

WIDTH, HEIGHT = 96, 64
PIXEL = 0.04  # metres a pixel
LEFT, LOW = -1.4, -1.28  # metres, of the picture's corner on the floor


def floor_of_pixel(x, y):
    return LEFT + (x + 0.5) * PIXEL, LOW + (y + 0.5) * PIXEL


def sees_ball(x, y):
    """The camera looks straight down."""
    at = floor_of_pixel(x, y)
    return (at[0] - ball.CENTER[0]) ** 2 + (at[1] - ball.CENTER[2]) ** 2 < ball.RADIUS**2


def in_shadow(x, z):
    to = (x - ball.CENTER[0], -ball.CENTER[1], z - ball.CENTER[2])
    along = ball.dot(to, ball.LIGHT)
    return ball.dot(to, to) - along * along < ball.RADIUS**2


def pixels():
    return [(x, y) for y in range(HEIGHT) for x in range(WIDTH)]
