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

    /// <summary>px.</summary>
    private const double CrossArm = 6.0;

    /// <summary>px: diameter from which a crater's name is drawn; smaller ones would cover each other.</summary>
    private const double NamedFrom = 40.0;

    /// <summary>
    /// Draws the outlines of craters, yellow, with the names of the larger ones, and landmarks as green crosses; grey where they are
    /// hidden.
    /// </summary>
    public static void Draw(Canvas image, NavigationTruth navigation)
    {
        foreach (CraterView view in navigation.Craters?.Views ?? [])
        {
            SetColor(image, view.Hidden > 0.5, 1.0, 0.9, 0.0);

            Draw(image, view);
        }

        foreach (LandmarkView view in navigation.Landmarks?.Views ?? [])
        {
            Draw(image, view);
        }
    }

    private static void Draw(Canvas image, LandmarkView view)
    {
        SetColor(image, view.HiddenBy is not null, 0.2, 1.0, 0.3);

        (double x, double y) = (view.X - 0.5, view.Y - 0.5);
        image.DrawLine(x - CrossArm, y, x + CrossArm, y, LineWidth);
        image.DrawLine(x, y - CrossArm, x, y + CrossArm, LineWidth);
        image.DrawText(view.Landmark.Name ?? view.Landmark.Identity, x + CrossArm, y - (0.5 * CrossArm), FontSize);
    }

    private static void Draw(Canvas image, CraterView view)
    {
        IReadOnlyList<RenderingPoint> outline = view.Curve.Count > 0
            ? view.Curve
            : [.. Enumerable.Range(0, OutlinePoints).Select(i => view.Ellipse.PointAt(2.0 * Math.PI * i / OutlinePoints))];

        // A canvas counts from the corner of the first pixel, rendering coordinates have its centre at 1.
        for (int i = 0; i < outline.Count; i++)
        {
            RenderingPoint from = outline[i];
            RenderingPoint to = outline[(i + 1) % outline.Count];
            if (IsNear(image, from) || IsNear(image, to))
            {
                image.DrawLine(from.X - 0.5, from.Y - 0.5, to.X - 0.5, to.Y - 0.5, LineWidth);
            }
        }

        if (view.Diameter >= NamedFrom)
        {
            string text = view.Crater.Name ?? view.Crater.Identity;
            image.DrawText(
                text, view.Ellipse.X - 0.5 - (0.5 * image.MeasureText(text, FontSize)), view.Ellipse.Y - 0.5 + (0.5 * FontSize), FontSize);
        }
    }

    private static void SetColor(Canvas image, bool isHidden, double red, double green, double blue)
    {
        (double r, double g, double b) = isHidden ? (0.6, 0.6, 0.6) : (red, green, blue);
        image.SetColor(r, g, b, 1.0);
    }

    /// <summary>Lines far outside are left out.</summary>
    private static bool IsNear(Canvas image, RenderingPoint point) =>
        point.X > -image.Width && point.X < 2.0 * image.Width && point.Y > -image.Height && point.Y < 2.0 * image.Height;
}
