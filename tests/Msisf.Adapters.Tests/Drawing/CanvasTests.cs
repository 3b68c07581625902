using Msisf.Adapters.Drawing;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Drawing;

public class CanvasTests
{
    [Fact]
    public void FillRectangle_WholeAndHalfPixels_CoverWhatTheyCover()
    {
        PngPixels image = Drawn(8, 4, canvas =>
        {
            canvas.SetColor(1.0, 0.0, 1.0, 1.0);
            canvas.FillRectangle(2.0, 1.0, 2.5, 2.0);
        });

        Assert.Equal((255, 0, 255), (image[3, 1, 0], image[3, 1, 1], image[3, 1, 2]));
        Assert.InRange(image[4, 2, 0], 126, 129); // half of it
        Assert.Equal((0, 0, 0), (image[1, 1, 0], image[2, 0, 0], image[5, 1, 0]));
    }

    [Fact]
    public void FillCircle_Area_IsPiRSquared()
    {
        PngPixels image = Drawn(41, 41, canvas =>
        {
            canvas.SetColor(1.0, 1.0, 1.0, 1.0);
            canvas.FillCircle(20.2, 20.7, 15.5);
        });

        double area = Enumerable.Range(0, 41 * 41).Sum(i => image[i % 41, i / 41, 0] / 255.0);
        Assert.Equal(Math.PI * 15.5 * 15.5, area, 0.005 * Math.PI * 15.5 * 15.5);
    }

    /// <summary>A line has its width and its length, and ends where it ends.</summary>
    [Theory]
    [InlineData(5.5, 10.5, 25.5, 10.5)]
    [InlineData(4.25, 3.5, 22.0, 24.75)]
    public void DrawLine_Area_IsLengthTimesWidth(double x1, double y1, double x2, double y2)
    {
        const double width = 3.0;
        PngPixels image = Drawn(32, 32, canvas =>
        {
            canvas.SetColor(1.0, 1.0, 1.0, 1.0);
            canvas.DrawLine(x1, y1, x2, y2, width);
        });

        double area = Enumerable.Range(0, 32 * 32).Sum(i => image[i % 32, i / 32, 0] / 255.0);
        double expected = width * double.Hypot(x2 - x1, y2 - y1);
        Assert.Equal(expected, area, 0.02 * expected);
    }

    [Fact]
    public void DrawImage_Smaller_HasTheMeanGrey()
    {
        using Canvas board = Canvas.Black(64, 64);
        board.SetColor(1.0, 1.0, 1.0, 1.0);
        for (int i = 0; i < 64 * 64; i += 2)
        {
            board.FillRectangle((i + (i / 64 % 2)) % 64, i / 64, 1.0, 1.0);
        }

        PngPixels image = Drawn(20, 20, canvas => canvas.DrawImage(board, 2.0, 2.0, 0.25));

        Assert.InRange(image[10, 10, 0], 120, 135);
        Assert.Equal((0, 0), (image[1, 10, 0], image[19, 10, 0]));
    }

    [Fact]
    public void DrawText_EachLetter_HasTheSameWidthAndNamesWithAccentsAreDrawn()
    {
        using Canvas canvas = Canvas.Black(200, 40);
        double one = canvas.MeasureText("i", 20.0);

        Assert.Equal(7.0 * one, canvas.MeasureText("Mwi\u010Cap\u00E9", 20.0), 1e-3);
        canvas.SetColor(1.0, 1.0, 1.0, 1.0);
        canvas.DrawText("\u010C", 10.0, 30.0, 20.0);
        PngPixels accented = Pixels(canvas);
        PngPixels plain = Drawn(200, 40, other =>
        {
            other.SetColor(1.0, 1.0, 1.0, 1.0);
            other.DrawText("C", 10.0, 30.0, 20.0);
        });
        Assert.Equal(0, Ink(plain, 0, 14)); // a capital letter is some 15 px high
        Assert.InRange(Ink(accented, 0, 14), 200, int.MaxValue);
        Assert.Equal(0, Ink(accented, 31, 40));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(20)]
    public void FromPng_NoWholeImage_IsBadInput(int bytes)
    {
        byte[] whole = PngBytes.Grey(64, 64, 40);

        Assert.Throws<BadInputException>(() => Canvas.FromPng(new MemoryStream(whole[..bytes])));
    }

    private static int Ink(PngPixels image, int top, int bottom) =>
        Enumerable.Range(top, bottom - top).Sum(y => Enumerable.Range(0, image.Width).Sum(x => image[x, y, 0]));

    private static PngPixels Drawn(int width, int height, Action<Canvas> draw)
    {
        using Canvas canvas = Canvas.Black(width, height);
        draw(canvas);
        return Pixels(canvas);
    }

    private static PngPixels Pixels(Canvas canvas)
    {
        using MemoryStream png = new();
        canvas.WritePng(png);
        png.Position = 0;
        return PngPixels.Read(png);
    }
}
