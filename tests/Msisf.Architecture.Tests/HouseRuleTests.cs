using System.CodeDom.Compiler;
using System.Reflection;
using System.Runtime.CompilerServices;
using System.Text.RegularExpressions;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.Architecture.Tests;

/// <summary>The rules of the house that reflection can see.</summary>
public sealed class HouseRuleTests
{
    private static readonly Type[] OwnTypes =
    [
        .. ((string[])["Msisf.Core", "Msisf.Synthesis", "Msisf.Adapters", "Msisf.MySql", "Msisf.App", "msis-server"])
            .SelectMany(name => Assembly.Load(name).GetTypes())
            .Where(
                type => type.GetCustomAttribute<CompilerGeneratedAttribute>() is null
                    && type.GetCustomAttribute<GeneratedCodeAttribute>() is null
                    && type.Namespace is not null // the class of top-level statements
                    && !type.FullName!.Contains('<', StringComparison.Ordinal)),
    ];

    [Fact]
    public void Structs_AreReadOnly() => // but those that never leave the stack, where nobody copies them by mistake
        Assert.All(
            OwnTypes.Where(type => type.IsValueType && !type.IsEnum && type.IsPublic && !type.IsByRefLike),
            type => Assert.True(type.GetCustomAttribute<IsReadOnlyAttribute>() is not null, $"{type.FullName} is a mutable struct"));

    [Fact]
    public void StaticFields_AreReadOnly() =>
        Assert.All(
            OwnTypes.SelectMany(
                type => type.GetFields(BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly)),
            field => Assert.True(
                field.IsInitOnly || field.IsLiteral
                    || field.DeclaringType!.FullName!.StartsWith("Msisf.Adapters.Interop.", StringComparison.Ordinal)
                    || field.GetCustomAttribute<CompilerGeneratedAttribute>() is not null,
                $"{field.DeclaringType!.FullName}.{field.Name} is mutable and static"));

    /// <summary>_camelCase for fields of objects, PascalCase for constants and fields of types.</summary>
    [Fact]
    public void PrivateFields_AreNamedAsFields() =>
        Assert.All(
            OwnTypes.SelectMany(type => type.GetFields(
                BindingFlags.Static | BindingFlags.Instance | BindingFlags.NonPublic | BindingFlags.DeclaredOnly))
                .Where(field => field.IsPrivate && !field.Name.Contains('<', StringComparison.Ordinal)),
            field => Assert.Matches(field.IsStatic ? "^[A-Z]" : "^_[a-z]", field.Name));

    [Fact]
    public void Exceptions_DeriveFromMsisfException() =>
        Assert.All(
            OwnTypes.Where(type => typeof(Exception).IsAssignableFrom(type)),
            type => Assert.True(typeof(MsisfException).IsAssignableFrom(type), $"{type.FullName} has no exit code"));

    [Fact]
    public void ConcreteClasses_AreSealed() =>
        Assert.All(
            OwnTypes.Where(type => type.IsClass && type.IsPublic && !type.IsAbstract && !OwnTypes.Any(other => other.BaseType == type)),
            type => Assert.True(type.IsSealed, $"{type.FullName} is not sealed"));

    /// <summary>
    /// STYLE: one public type a file; a small one may stand with the type that it belongs to.
    /// </summary>
    [Fact]
    public void PublicTypes_LieInTheFileOfTheirNameOrAreSmall()
    {
        const int Small = 24; // lines
        string[] files =
        [
            .. Directory.EnumerateFiles(Path.Combine(TestSupport.TestParts.RepositoryRoot, "src"), "*.cs", SearchOption.AllDirectories)
                .Where(path => !path.Contains("/obj/", StringComparison.Ordinal)),
        ];
        HashSet<string> names = [.. files.Select(path => Path.GetFileNameWithoutExtension(path))];
        string[] types = [.. files.SelectMany(path => File.ReadAllText(path).Split("\n/// <summary>"))];
        Assert.All(
            OwnTypes.Where(type => type.IsPublic).Select(type => type.Name.Split('`')[0]).Where(name => !names.Contains(name)),
            name =>
            {
                Regex declaration = new($@"\npublic [a-z ]*\b(class|interface|struct|record|enum|delegate \w+) {name}\b");
                int lines = Assert.Single(types, text => declaration.IsMatch(text)).Trim().Split('\n').Length;
                Assert.True(lines <= Small, $"{name} is neither in a file of its name nor small");
            });
    }
}
