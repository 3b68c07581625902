using Msisf.Adapters.Drawing;
using Msisf.Core.Camera;
using Msisf.Core.Navigation;

namespace Msisf.Adapters.Metadata;

/// <summary>Draws truth for navigation on an image.</summary>
internal static class NavigationDrawing
{
    private const int OutlinePoints = 72;

    private const double LineWidth = 1.2;

    private const double FontSize = 11.0;

    /// <summary>Part of the font's size that letters reach below the base line.</summary>
    private const double Descent = 0.25;

    /// <summary>px.</summary>
    private const double CrossArm = 6.0;

    /// <summary>px: diameter from which a crater's name is drawn; smaller ones would cover each other.</summary>
    private const double NamedFrom = 40.0;

    private static readonly (double Red, double Green, double Blue) Yellow = (1.0, 0.9, 0.0);
    private static readonly (double Red, double Green, double Blue) Green = (0.2, 1.0, 0.3);
    private static readonly (double Red, double Green, double Blue) Grey = (0.6, 0.6, 0.6);

    /// <summary>
    /// Draws the outlines of craters, yellow, with the names of the larger ones, and landmarks as green crosses; grey where they are
    /// hidden. A name that would cover another one, or the text, is left out: that of the smaller crater.
    /// </summary>
    public static void Draw(Canvas image, NavigationTruth navigation, TextBlock block)
    {
        List<Box> taken = [];
        foreach (CraterView view in (navigation.Craters?.Views ?? []).OrderByDescending(view => view.Diameter))
        {
            Draw(image, view, block, taken);
        }

        foreach (LandmarkView view in navigation.Landmarks?.Views ?? [])
        {
            Draw(image, view, block, taken);
        }
    }

    private static void Draw(Canvas image, LandmarkView view, TextBlock block, List<Box> taken)
    {
        (double Red, double Green, double Blue) color = view.HiddenBy is null ? Green : Grey;
        (double x, double y) = (view.X - 0.5, view.Y - 0.5);
        image.DrawOutlined(color, wider =>
        {
            double width = LineWidth + (2.0 * wider);
            image.DrawLine(x - CrossArm - wider, y, x + CrossArm + wider, y, width);
            image.DrawLine(x, y - CrossArm - wider, x, y + CrossArm + wider, width);
        });
        DrawName(
            image, view.Landmark.Name ?? view.Landmark.Identity, x + CrossArm, y - (0.5 * CrossArm), color, block, taken);
    }

    private static void Draw(Canvas image, CraterView view, TextBlock block, List<Box> taken)
    {
        IReadOnlyList<RenderingPoint> outline = view.Curve.Count > 0
            ? view.Curve
            : [.. Enumerable.Range(0, OutlinePoints).Select(i => view.Ellipse.PointAt(2.0 * Math.PI * i / OutlinePoints))];
        (double Red, double Green, double Blue) color = view.Hidden > 0.5 ? Grey : Yellow;

        // A canvas counts from the corner of the first pixel, rendering coordinates have its centre at 1.
        image.DrawOutlined(color, wider =>
        {
            for (int i = 0; i < outline.Count; i++)
            {
                RenderingPoint from = outline[i];
                RenderingPoint to = outline[(i + 1) % outline.Count];
                if (IsNear(image, from) || IsNear(image, to))
                {
                    image.DrawLine(from.X - 0.5, from.Y - 0.5, to.X - 0.5, to.Y - 0.5, LineWidth + (2.0 * wider));
                }
            }
        });
        if (view.Diameter >= NamedFrom)
        {
            string text = view.Crater.Name ?? view.Crater.Identity;
            double left = view.Ellipse.X - 0.5 - (0.5 * image.MeasureText(text, FontSize));
            DrawName(image, text, left, view.Ellipse.Y - 0.5 + (0.5 * FontSize), color, block, taken);
        }
    }

    /// <summary>Draws a name where no other one is.</summary>
    /// <param name="x">px: where its base line begins.</param>
    private static void DrawName(
        Canvas image, string text, double x, double y, (double Red, double Green, double Blue) color, TextBlock block, List<Box> taken)
    {
        Box box = new(x, y - FontSize, x + image.MeasureText(text, FontSize), y + (Descent * FontSize));
        if (block.Covers(box.Left, box.Top) || taken.Exists(other => other.Meets(box)))
        {
            return;
        }

        taken.Add(box);
        image.DrawOutlined(color, wider => image.DrawText(text, x, y, FontSize, wider));
    }

    /// <summary>Lines far outside are left out.</summary>
    private static bool IsNear(Canvas image, RenderingPoint point) =>
        point.X > -image.Width && point.X < 2.0 * image.Width && point.Y > -image.Height && point.Y < 2.0 * image.Height;

    /// <summary>A rectangle of the image, px.</summary>
    private readonly record struct Box(double Left, double Top, double Right, double Bottom)
    {
        public bool Meets(in Box other) => Left < other.Right && other.Left < Right && Top < other.Bottom && other.Top < Bottom;
    }
}
