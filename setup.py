"""For catkin_python_setup(), which reads the rest from package.xml; not to be run by hand."""

from catkin_pkg.python_setup import generate_distutils_setup
from setuptools import setup

setup(**generate_distutils_setup(packages=["devo_evo", "devo_evo.claims", "devo_evo.figures"], package_dir={"": "src"}))
